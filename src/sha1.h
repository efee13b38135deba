// The fingerprint that ties a picture to the bytes of its scene file.
#pragma once

#include <string>

namespace gnomon {

/// SHA-1 of the bytes, as 40 lower-case hex digits. A fingerprint, not a protection. Throws Error(Blame::run).
std::string sha1_hex(const std::string& bytes);

}  // namespace gnomon
