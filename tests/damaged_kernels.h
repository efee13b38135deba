// Kernels that are wrong on purpose, for as long as the object lives.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "catch.h"
#include "run_program.h"

namespace gnomon::test {

/// In a file of cl/, a text and what is to stand there.
struct Damage {
    std::string file, text, wrong;
};

/// A copy of cl/ with damages; whatever is built meanwhile is built from it.
class DamagedKernels {
  public:
    explicit DamagedKernels(const std::vector<Damage>& damages) {
        const std::filesystem::path kernels = std::filesystem::path(GNOMON_SOURCE_DIR) / "cl";
        for (const auto& entry : std::filesystem::directory_iterator(kernels))
            write_file(folder_ / entry.path().filename().string(), read_file(entry.path().string()));
        for (const Damage& damage : damages) {
            std::string source = read_file(folder_ / damage.file);
            const size_t at = source.find(damage.text);
            INFO(damage.file << ": " << damage.text);
            REQUIRE(at != std::string::npos);
            write_file(folder_ / damage.file, source.replace(at, damage.text.size(), damage.wrong));
        }
        setenv(variable, folder_.path().c_str(), 1);
    }
    ~DamagedKernels() { unsetenv(variable); }
    DamagedKernels(const DamagedKernels&) = delete;
    DamagedKernels& operator=(const DamagedKernels&) = delete;

    /// Where they are, as a setting for run_program.
    std::string environment() const { return std::string(variable) + "=" + quoted(folder_.path()); }

  private:
    static constexpr const char* variable = "GNOMON_CL_DIR";
    TempFolder folder_;
};

}  // namespace gnomon::test
