// The program as a user runs it: a command line in, exit code and what it printed out.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "catch.h"
#include "scenes.h"

namespace gnomon::test {

/// A folder of a test's own, gone with the object.
class TempFolder {
  public:
    TempFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "gnomon_test_XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    /// A file in it.
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string path() const { return path_.string(); }
    /// How many files and folders lie in it.
    size_t count() const {
        const std::filesystem::directory_iterator first(path_);
        return static_cast<size_t>(std::distance(begin(first), end(first)));
    }

  private:
    std::filesystem::path path_;
};

inline std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

inline void write_file(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

inline std::string quoted(const std::string& path) { return "'" + path + "'"; }

/// Variables of the surroundings that would change what the program does are taken away first.
inline const char* clean_environment =
    "env -u GNOMON_DEVICE -u GNOMON_CL_DIR -u GNOMON_CACHE_DIR -u OCL_ICD_VENDORS -u OCL_ICD_FILENAMES -u "
    "SOURCE_DATE_EPOCH ";

struct Ran {
    int code;  ///< -1 when a signal ended it
    std::string out, err;
};

/// Runs `gnomon arguments`; `environment` is "NAME=value ...", `before` shell commands.
inline Ran run_program(const std::string& arguments, const std::string& environment = "",
                       const std::string& before = "") {
    const TempFolder folder;
    const std::string out = folder / "out", err = folder / "err";
    const std::string command = before + clean_environment + environment + " " + quoted(GNOMON_PROGRAM) + " " +
                                arguments + " >" + quoted(out) + " 2>" + quoted(err) + " </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

/// Bad usage or input, and a message that says so.
inline void check_refused(const Ran& ran, const std::string& expected) {
    INFO(ran.err);
    CHECK(ran.code == 2);
    CHECK(contains(ran.err, expected));
}

/// The same, and nothing was printed before.
inline void check_refused_at_once(const Ran& ran, const std::string& expected) {
    check_refused(ran, expected);
    CHECK(ran.out.empty());
}

inline std::string example_path(const std::string& name) {
    return quoted(std::string(GNOMON_SOURCE_DIR) + "/examples/" + name);
}

/// `gnomon render` of an example at a size that takes no time.
inline Ran render_small(const std::string& arguments, const std::string& environment = "",
                        const std::string& scene = "directional.json") {
    return run_program("render " + example_path(scene) + " --size 40x30 " + arguments, environment);
}

}  // namespace gnomon::test
