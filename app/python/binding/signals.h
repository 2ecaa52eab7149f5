#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "app/python/binding/errors.h"

namespace scb::python {

/// Lets Ctrl-C end work that threads share without the interpreter's lock. The thread that makes it
/// must have released the lock; it alone looks for signals, since Python wants no other to, and at
/// most ten times a second.
class SignalWatch {
  public:
    /// Whether the work is to end; any of the threads may ask.
    bool stopped();
    /// Throws what the signal's handler raised in Python, if anything. For the first thread.
    void rethrow();

  private:
    using Clock = std::chrono::steady_clock;
    const std::thread::id first_ = std::this_thread::get_id();
    Clock::time_point looked_ = Clock::now();
    std::atomic<bool> stopped_ = false;
};

}  // namespace scb::python
