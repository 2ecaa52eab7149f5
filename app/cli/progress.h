#pragma once

#include <chrono>
#include <string_view>

#include "app/cli/console.h"

namespace scb::app {

/// The progress of a run of many like steps, with an estimate of the time that remains, shown ten
/// times a second at most.
class Progress {
  public:
    Progress(const Console& console, std::size_t total);

    /// One more step is done; `what` stands beside the bar.
    void step(std::string_view what);

  private:
    using Clock = std::chrono::steady_clock;

    const Console& console_;
    std::size_t done_ = 0, total_;
    Clock::time_point start_ = Clock::now(), shown_{};
};

}  // namespace scb::app
