// Ending work before it is done.
#pragma once

#include <atomic>
#include <exception>

namespace gnomon {

/// Thrown by work that was asked to stop.
class Stopped : public std::exception {
  public:
    const char* what() const noexcept override { return "stopped"; }
};

/// Whether work should stop. May be asked to by any thread, and in a signal handler.
class Stop {
  public:
    void ask() noexcept { asked_ = true; }
    bool is_asked() const noexcept { return asked_; }

  private:
    static_assert(std::atomic<bool>::is_always_lock_free);  // or signal handlers could not touch it
    std::atomic<bool> asked_{false};
};

/// Throws Stopped if it is asked for; null never is.
inline void check(const Stop* stop) {
    if (stop && stop->is_asked()) throw Stopped();
}

}  // namespace gnomon
