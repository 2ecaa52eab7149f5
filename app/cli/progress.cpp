#include "app/cli/progress.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/text_format.h"

namespace scb::app {
namespace {

/// ", 12 per second, about 8 s left"; for slow steps ", 2.5 s each, about 3 min left".
std::string pace(double seconds_per_step, std::size_t left) {
    const double seconds = seconds_per_step * static_cast<double>(left);
    return (seconds_per_step < 1 ? format(", %.3g per second", 1 / seconds_per_step)
                                 : format(", %.2g s each", seconds_per_step)) +
           (seconds < 100 ? format(", about %.0f s left", std::ceil(seconds))
                          : format(", about %.0f min left", std::ceil(seconds / 60)));
}

}  // namespace

Progress::Progress(const Console& console, std::size_t total) : console_(console), total_(total) {}

void Progress::at(std::string_view what, std::size_t done) {
    done_ = std::min(done, total_);
    if (whole_) return;  // it is shown, and its line has ended
    whole_ = done_ == total_;
    const Clock::time_point now = Clock::now();
    if (done_ < total_ && now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    // An early estimate would only flicker.
    console_.progress(
        std::string(what) + (elapsed > 1 && 0 < done_ && done_ < total_
                                 ? pace(elapsed / static_cast<double>(done_), total_ - done_)
                                 : ""),
        done_, total_);
}

}  // namespace scb::app
