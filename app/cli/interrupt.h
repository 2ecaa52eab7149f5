#pragma once

#include <signal.h>

#include <array>

namespace scb::app {

/// While an object of this class exists, Ctrl-C (SIGINT), SIGTERM and SIGHUP do not end the program
/// but are remembered. So a long run can stop between two results and keep the finished ones. A
/// second signal, 0.3 s later or more, ends the program.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// The signal received, or 0.
    int signal() const;

  private:
    std::array<struct sigaction, 3> before_{};
};

}  // namespace scb::app
