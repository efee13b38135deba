// Kernels that were built, kept on disk for drivers that keep none themselves.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "device.h"

namespace gnomon {

/// A folder with a file for each key, named by the key's SHA-1. Several processes may use one folder: a file is there
/// whole or not at all, and whatever is damaged, cut short or of another key is as good as not there.
class BinaryCache {
  public:
    explicit BinaryCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What was kept under the key, if anything was.
    std::optional<std::string> find(const std::string& key) const;

    /// Keeps the binary, in place of what is there. Throws Error(Blame::run) where the folder cannot be written to.
    void keep(const std::string& key, const std::string& binary) const;

    std::filesystem::path file_of(const std::string& key) const;

  private:
    std::filesystem::path folder_;
};

/// The cache for a device: in $GNOMON_CACHE_DIR if that is set (none if it is empty); else, for drivers that keep no
/// binaries, in $XDG_CACHE_HOME/gnomon or ~/.cache/gnomon. PoCL and NVIDIA's driver keep their own, better: the machine
/// code of each size of work-group too.
std::optional<BinaryCache> binary_cache_for(const DeviceInfo& device);

}  // namespace gnomon
