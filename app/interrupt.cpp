#include "app/interrupt.h"

#include <time.h>

#include <csignal>

namespace scb {
namespace {

// What a signal handler may write. The time is read by handlers alone.
volatile sig_atomic_t received = 0;
timespec received_at{};

void remember(int signal) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (received == 0) {
        received_at = now;
        received = signal;
        return;
    }
    // Some programs send one signal to the process and to its group: that is one, not two.
    constexpr double one_signal = 0.3;  // seconds
    const double apart = static_cast<double>(now.tv_sec - received_at.tv_sec) +
                         1e-9 * static_cast<double>(now.tv_nsec - received_at.tv_nsec);
    if (apart < one_signal) return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

constexpr int signals[] = {SIGINT, SIGTERM};

}  // namespace

InterruptWatch::InterruptWatch() {
    received = 0;
    struct sigaction action {};
    action.sa_handler = remember;
    for (std::size_t i = 0; i < before_.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        // A program that was told to ignore it goes on doing so.
        if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (std::size_t i = 0; i < before_.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

int InterruptWatch::signal() const { return received; }

}  // namespace scb
