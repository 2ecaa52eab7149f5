#pragma once

#include <chrono>
#include <string_view>

#include "app/cli/console.h"

namespace scb::app {

/// The progress of a run of many like steps, with how many are done in a second, and an estimate of
/// the time that remains, shown ten times a second at most.
class Progress {
  public:
    Progress(const Console& console, std::size_t total);

    /// One more step is done; `what` stands beside the bar.
    void step(std::string_view what) { at(what, done_ + 1); }
    /// So many are done by now.
    void at(std::string_view what, std::size_t done);

  private:
    using Clock = std::chrono::steady_clock;

    const Console& console_;
    std::size_t done_ = 0, total_;
    Clock::time_point start_ = Clock::now(), shown_{};
};

}  // namespace scb::app
