#pragma once

#include <chrono>
#include <string_view>

#include "app/cli/console.h"

namespace scb::app {

/// The progress of a run of many similar steps: their rate, and an estimate of the remaining time;
/// updated at most ten times a second.
class Progress {
  public:
    Progress(const Console& console, std::size_t total);

    /// One more step is done; `what` is shown beside the bar.
    void step(std::string_view what) { at(what, done_ + 1); }
    /// Sets the number of steps done.
    void at(std::string_view what, std::size_t done);

  private:
    using Clock = std::chrono::steady_clock;

    const Console& console_;
    std::size_t done_ = 0, total_;
    Clock::time_point start_ = Clock::now(), shown_{};
    bool whole_ = false;  ///< the end was shown
};

}  // namespace scb::app
