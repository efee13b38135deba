#include "binary_cache.h"

#include <cstdlib>
#include <mutex>

#include "error.h"
#include "sha1.h"
#include "temporary_file.h"

namespace gnomon {

namespace fs = std::filesystem;

namespace {

// A file is this line, the SHA-1 of all that follows it, the SHA-1 of the key, and the binary.
const std::string first_line = "gnomon: built kernels, format 1\n";
constexpr size_t digest_size = 40;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

fs::path users_folder() {
    const std::string caches = environment("XDG_CACHE_HOME"), home = environment("HOME");
    if (!caches.empty()) return fs::path(caches) / "gnomon";
    return home.empty() ? fs::path() : fs::path(home) / ".cache" / "gnomon";
}

bool keeps_binaries(const DeviceInfo& device) {
    return device.platform_name == "Portable Computing Language" || device.platform_name == "NVIDIA CUDA";
}

}  // namespace

fs::path BinaryCache::file_of(const std::string& key) const { return folder_ / (sha1_hex(key) + ".kernels"); }

std::optional<std::string> BinaryCache::find(const std::string& key) const {
    const std::string bytes = read_text(file_of(key)), digest = sha1_hex(key);
    const size_t start = first_line.size() + digest_size;
    if (bytes.size() < start + digest_size || bytes.compare(0, first_line.size(), first_line) != 0) return std::nullopt;
    const std::string rest = bytes.substr(start);
    if (bytes.compare(first_line.size(), digest_size, sha1_hex(rest)) != 0) return std::nullopt;
    if (rest.compare(0, digest_size, digest) != 0) return std::nullopt;
    return rest.substr(digest_size);
}

void BinaryCache::keep(const std::string& key, const std::string& binary) const {
    // Temporary files have the process's number in their names: one thread of a process at a time.
    static std::mutex one_at_a_time;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw Error(Blame::run, "cannot make the folder: " + error.message(), folder_.string());
    const std::string rest = sha1_hex(key) + binary;
    write_text(file_of(key).string(), first_line + sha1_hex(rest) + rest);
}

std::optional<BinaryCache> binary_cache_for(const DeviceInfo& device) {
    const char* chosen = std::getenv("GNOMON_CACHE_DIR");
    const fs::path folder = chosen ? fs::path(chosen) : keeps_binaries(device) ? fs::path() : users_folder();
    return folder.empty() ? std::nullopt : std::optional(BinaryCache(folder));
}

}  // namespace gnomon
