// What is under way, for those who wait.
#pragma once

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace gnomon {

/// In one line that is written over, if somebody looks; an empty one leaves nothing.
inline void say_progress(const std::string& what) {
    if (isatty(STDERR_FILENO) == 0) return;
    fmt::print(stderr, "\r\033[K{}", what);
    std::fflush(stderr);
}

}  // namespace gnomon
