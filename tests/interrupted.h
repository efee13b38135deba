// The program as a user who interrupts it runs it.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "run_program.h"

namespace gnomon::test {

struct Interrupted {
    int code;        ///< -1 when it was ended by a signal
    double seconds;  ///< from the signal to its end
    std::string out, err;
};

/// Whether the moment has come. Is asked again and again, and told the process and what that has printed.
using Moment = std::function<bool(pid_t program, const std::string& out)>;

/// The process of the program, run as a shell would, with these files for what it prints.
inline pid_t start_program(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
    std::vector<char*> argv{const_cast<char*>(GNOMON_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    signal(SIGINT, SIG_DFL);  // whoever runs tests in the background may ignore it
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(GNOMON_PROGRAM, argv.data());
    _exit(127);
}

/// Runs the program and sends it a signal at a moment; when it ends before that, none.
inline Interrupted interrupt(const std::vector<std::string>& arguments, int signal, const Moment& moment) {
    using Clock = std::chrono::steady_clock;
    const TempFolder said;
    const std::string out = said / "out", err = said / "err";
    const pid_t child = start_program(arguments, out, err);
    int status = 0;
    bool ended = false;
    while (!ended && !moment(child, read_file(out))) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ended = waitpid(child, &status, WNOHANG) != 0;
    }
    const Clock::time_point start = Clock::now();
    if (!ended) {
        kill(child, signal);
        waitpid(child, &status, 0);
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, seconds, read_file(out), read_file(err)};
}

}  // namespace gnomon::test
