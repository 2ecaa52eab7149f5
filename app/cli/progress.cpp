#include "app/cli/progress.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace scb::app {
namespace {

std::string remaining(double seconds) {
    char text[64];
    if (seconds < 100)
        std::snprintf(text, sizeof text, ", about %.0f s left", std::ceil(seconds));
    else
        std::snprintf(text, sizeof text, ", about %.0f min left", std::ceil(seconds / 60));
    return text;
}

}  // namespace

Progress::Progress(const Console& console, std::size_t total) : console_(console), total_(total) {}

void Progress::step(std::string_view what) {
    ++done_;
    const Clock::time_point now = Clock::now();
    if (done_ < total_ && now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = elapsed * static_cast<double>(total_ - done_) / static_cast<double>(done_);
    // An estimate after a moment would only flicker.
    console_.progress(std::string(what) + (elapsed > 1 && done_ < total_ ? remaining(left) : ""),
                      done_, total_);
}

}  // namespace scb::app
