#include "spawn.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "error.h"

namespace bench {

using namespace gnomon;

namespace {

/// The child's half of a fork: becomes the program or ends.
[[noreturn]] void become(const Spawn& spawn, std::vector<char*>& arguments) {
    constexpr int not_started = 127;  // as shells say it
    for (const auto& [name, value] : spawn.environment) setenv(name.c_str(), value.c_str(), 1);
    if (spawn.cpus && sched_setaffinity(0, sizeof *spawn.cpus, spawn.cpus) != 0) _exit(not_started);
    if (spawn.silent) {
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    execv(arguments[0], arguments.data());
    _exit(not_started);
}

}  // namespace

int run_program(const Spawn& spawn) {
    std::vector<std::string> texts = spawn.arguments;
    std::vector<char*> arguments;
    for (std::string& text : texts) arguments.push_back(text.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) become(spawn, arguments);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

cpu_set_t own_cpus() {
    cpu_set_t cpus;
    if (sched_getaffinity(0, sizeof cpus, &cpus) != 0) throw Error(Blame::run, "cannot tell the processors");
    return cpus;
}

cpu_set_t first_cpus(int count) {
    const cpu_set_t all = own_cpus();
    if (count < 1 || count > CPU_COUNT(&all))
        throw Error(Blame::input, "there are " + std::to_string(CPU_COUNT(&all)) + " cores", "--cores");
    cpu_set_t cpus;
    CPU_ZERO(&cpus);
    for (size_t cpu = 0; CPU_COUNT(&cpus) < count; ++cpu)
        if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &cpus);
    return cpus;
}

}  // namespace bench
