#include "sha1.h"

#include <openssl/evp.h>

#include "error.h"

namespace gnomon {

std::string sha1_hex(const std::string& bytes) {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    // A build of OpenSSL may leave SHA-1 out (FIPS), so that this can fail for any input.
    if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha1(), nullptr) != 1) {
        throw Error(Blame::run, "OpenSSL cannot compute SHA-1");
    }
    static const char digits[] = "0123456789abcdef";
    std::string hex;
    for (unsigned int i = 0; i < size; ++i) hex += {digits[digest[i] >> 4], digits[digest[i] & 15]};
    return hex;
}

}  // namespace gnomon
