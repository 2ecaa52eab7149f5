#pragma once

#include <string>
#include <vector>

#include "core/analysis/alternative_test.h"
#include "core/analysis/inspection.h"
#include "render/overlay/overlay.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace scb::render {

/// What the same queries take with a volume and what is best for it.
struct InspectedSetting {
    std::string name;  ///< of the volume
    Work counts;
    bool recommended = false;
};

/// What the tests of queries wasted and why: per frame, per depth and in all, and what other
/// settings and overlap tests would have done.
struct InspectFigure {
    std::string title;
    std::string subtitle;
    std::vector<InspectedFrame> frames;  ///< in any order
    Inspection sum;
    Work settings_from;                      ///< what the settings are compared with
    std::vector<InspectedSetting> settings;  ///< by cost, the least first
    std::string best;                        ///< the recommended one: all of it
    std::vector<AlternativeTest> others;     ///< what others would have done
    const Theme* theme = &light_theme;
};

/// The color of pairs that passed for that reason, and of what came of them: neutral where
/// triangles meet, purple (as in pictures of rejections) for loose fits, the accent for false
/// positives of the test.
Rgba8 pass_reason_color(PassReason reason, const Theme& theme);
/// Of pairs that were rejected wrongly: that of alarms.
Rgba8 wrong_rejection_color(const Theme& theme);

/// How much more or less that is: "+9.6 %", "−3.9 %"; a dash where there was nothing.
std::string change_text(std::uint64_t from, std::uint64_t to);

Picture compose(const InspectFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
