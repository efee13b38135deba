// Other programs, and this one again.
#pragma once

#include <sched.h>

#include <string>
#include <utility>
#include <vector>

namespace bench {

struct Spawn {
    std::vector<std::string> arguments;                                 ///< the program's path first
    std::vector<std::pair<std::string, std::string>> environment = {};  ///< added to this process's
    const cpu_set_t* cpus = nullptr;  ///< where it may run; null: where this process may
    bool silent = false;              ///< what it prints goes nowhere
};

/// Waits for its end. Returns its exit code, -1 when it could not start or a signal ended it.
int run_program(const Spawn& spawn);

/// The processors that this process may run on.
cpu_set_t own_cpus();

/// The first `count` of them; throws Error(Blame::input) when there are fewer.
cpu_set_t first_cpus(int count);

}  // namespace bench
