#pragma once

#include <signal.h>

#include <array>

namespace scb::app {

/// While one of these exists, Ctrl-C (SIGINT), SIGTERM and SIGHUP do not end the program but are
/// remembered, so that a long run can stop between two results and leave what it has finished. A
/// second one, 0.3 s later or more, ends the program.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// The signal that came, or 0.
    int signal() const;

  private:
    std::array<struct sigaction, 3> before_{};
};

}  // namespace scb::app
