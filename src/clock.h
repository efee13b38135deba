// Wall time in seconds, for differences.
#pragma once

#include <chrono>

namespace gnomon {

inline double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace gnomon
