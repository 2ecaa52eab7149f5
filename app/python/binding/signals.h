#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "app/python/binding/errors.h"

namespace scb::python {

/// Lets Ctrl-C end work of several threads without the interpreter's lock. The thread that creates
/// the object must have released the lock. Only this thread checks for signals, as Python requires,
/// and at most ten times a second.
class SignalWatch {
  public:
    /// Whether the work is to end; any thread may call it.
    bool stopped();
    /// Throws the exception of Python's signal handler, if any. Only for the first thread.
    void rethrow();

  private:
    using Clock = std::chrono::steady_clock;
    const std::thread::id first_ = std::this_thread::get_id();
    Clock::time_point looked_ = Clock::now();
    std::atomic<bool> stopped_ = false;
};

}  // namespace scb::python
