#include "gnuplot.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <list>

#include "error.h"
#include "temporary_file.h"

namespace gnomon::report {

namespace {

namespace fs = std::filesystem;

/// Gone with the object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "gnomon_report_XXXXXX").string();
        if (!mkdtemp(name.data())) throw Error(Blame::run, "cannot make a temporary folder", name, "set TMPDIR");
        path_ = name;
        for (const char* file : {"", "script.gp", "said", "out.svg"}) fleeting_.emplace_back(path_ / file);
    }
    ~TemporaryFolder() {
        std::error_code ignored;  // a destructor has nobody to tell
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
    std::list<Fleeting> fleeting_;  // what an interrupt has to remove
};

constexpr int not_started = 127;  // as shells say it

/// The child's half of a fork: only calls that are safe there. What gnuplot says goes to the file "said".
[[noreturn]] void become_gnuplot(const char* folder, const char* argument) {
    char program[] = "gnuplot", *arguments[] = {program, const_cast<char*>(argument), nullptr};
    if (chdir(folder) != 0) _exit(not_started);
    const int said = open("said", O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (said < 0 || nothing < 0) _exit(not_started);
    dup2(nothing, STDIN_FILENO);
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    execvp(program, arguments);
    _exit(not_started);
}

/// Its exit code; -1 when a signal ended it.
int gnuplot(const fs::path& folder, const char* argument) {
    const pid_t child = fork();
    if (child == 0) become_gnuplot(folder.c_str(), argument);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) throw Error(Blame::run, "cannot start a program", "gnuplot");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string draw_one(const fs::path& folder, const std::string& script) {
    const fs::path svg = folder / "out.svg";
    fs::remove(svg);
    write_text((folder / "script.gp").string(), script);
    const int code = gnuplot(folder, "script.gp");
    const std::string drawn = read_text(svg);
    if (code != 0 || drawn.find("</svg>") == std::string::npos)
        throw Error(Blame::run,
                    "gnuplot failed (exit code " + std::to_string(code) + "): " + read_text(folder / "said"), "plots",
                    "the report needs gnuplot 5.4 or later");
    return drawn;
}

}  // namespace

bool has_gnuplot() { return gnuplot(TemporaryFolder().path(), "--version") == 0; }

std::vector<std::string> draw(const std::vector<std::string>& scripts) {
    const TemporaryFolder folder;
    std::vector<std::string> svgs;
    for (const std::string& script : scripts) svgs.push_back(draw_one(folder.path(), script));
    return svgs;
}

}  // namespace gnomon::report
