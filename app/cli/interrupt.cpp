#include "app/cli/interrupt.h"

#include <time.h>

#include <atomic>
#include <csignal>
#include <cstdint>

namespace scb::app {
namespace {

// Variables that a signal handler may write and other threads read.
std::atomic<int> received = 0;
static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<std::int64_t> received_at = 0;  // nanoseconds
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

void remember(int signal) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const std::int64_t time = std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
    if (received == 0) {
        received_at = time;
        received = signal;
        return;
    }
    // Some programs send a signal to the process and also to its group: count it once.
    constexpr std::int64_t one_signal = 300'000'000;
    if (time - received_at < one_signal) return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

}  // namespace

InterruptWatch::InterruptWatch() {
    received = 0;
    struct sigaction action {};
    action.sa_handler = remember;
    // Output in progress continues.
    action.sa_flags = SA_RESTART;
    for (const int signal : signals) sigaddset(&action.sa_mask, signal);
    for (std::size_t i = 0; i < before_.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        // If the parent process set the signal to be ignored, keep ignoring it.
        if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (std::size_t i = 0; i < before_.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

int InterruptWatch::signal() const { return received; }

}  // namespace scb::app
