#include "app/interrupt.h"

namespace scb {
namespace {

// Signal handlers may write nothing else.
volatile sig_atomic_t received = 0;

void remember(int signal) { received = signal; }

constexpr int signals[] = {SIGINT, SIGTERM};

}  // namespace

InterruptWatch::InterruptWatch() {
    received = 0;
    struct sigaction action {};
    action.sa_handler = remember;
    // The second signal ends the program.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
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
