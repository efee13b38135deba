#include "interrupt.h"

#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

#include "error.h"
#include "temporary_file.h"

namespace gnomon {

namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
constexpr long patience = 500'000'000;  // ns

std::atomic<Stop*> heeds{nullptr};
std::atomic<int> caught{0};
timer_t timer;
pthread_t main_thread;

const char* message_of(int signal) {
    if (signal == SIGINT) return "gnomon: interrupted (SIGINT)\n";
    return signal == SIGTERM ? "gnomon: interrupted (SIGTERM)\n" : "gnomon: interrupted (SIGHUP)\n";
}

void say(int signal) {
    const char* const message = message_of(signal);
    if (write(STDERR_FILENO, message, std::strlen(message)) < 0) return;  // there is nobody to tell that to
}

/// Only what signal handlers may call (signal-safety(7)).
[[noreturn]] void leave(int signal) {
    remove_temporary_files();
    say(signal);
    _exit(128 + signal);
}

/// Whether another thread than the main one was interrupted: that is then given the signal. It is the one that writes
/// files, and must not make another when those that are there have been removed.
bool is_passed_on(int signal) {
    return !pthread_equal(pthread_self(), main_thread) && pthread_kill(main_thread, signal) == 0;
}

void on_signal(int signal) {
    if (is_passed_on(signal)) return;
    const int error = errno;
    int none = 0;
    Stop* const stop = heeds;
    if (!stop || !caught.compare_exchange_strong(none, signal)) leave(signal);
    stop->ask();
    const itimerspec once{{0, 0}, {0, patience}};
    timer_settime(timer, 0, &once, nullptr);
    errno = error;
}

void on_timer(int signal) {
    if (!is_passed_on(signal)) leave(caught);
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    for (const int other : signals) sigaddset(&action.sa_mask, other);
    sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts() {
    main_thread = pthread_self();
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0)
        throw Error(Blame::run, std::string("cannot make a timer: ") + std::strerror(errno));
    handle(SIGALRM, on_timer);
    for (const int signal : signals)
        if (!is_ignored(signal)) handle(signal, on_signal);
}

bool was_interrupted() { return caught != 0; }

int interrupted() {
    const itimerspec never{};
    timer_settime(timer, 0, &never, nullptr);
    say(caught);
    return 128 + caught;
}

Stoppable::Stoppable() { heeds = &stop_; }
Stoppable::~Stoppable() { heeds = nullptr; }

}  // namespace gnomon
