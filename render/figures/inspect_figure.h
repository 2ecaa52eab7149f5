#pragma once

#include <string>
#include <vector>

#include "core/analysis/alternative_test.h"
#include "core/analysis/inspection.h"
#include "render/overlay/overlay.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace scb::render {

/// The cost of the same queries with another volume and the best setting for it.
struct InspectedSetting {
    std::string name;  ///< of the volume
    Work counts;
    bool recommended = false;
};

/// The wasted tests of queries, with reasons: per frame, per depth and in all; and the costs with
/// other settings and overlap tests.
struct InspectFigure {
    std::string title;
    std::string subtitle;
    QueryKind kind = QueryKind::collide;
    std::vector<InspectedFrame> frames;  ///< in any order
    Inspection sum;
    Work settings_from;                      ///< the base that settings are compared with
    std::vector<InspectedSetting> settings;  ///< by cost, the least first
    std::string best;                        ///< the whole recommended setting
    std::vector<AlternativeTest> others;     ///< the results of other overlap tests
    const Theme* theme = &light_theme;
};

/// The color of pairs that passed for this reason, and of their results: neutral if triangles meet,
/// purple (as in pictures of rejections) for loose fits, the accent for false positives of the
/// test.
Rgba8 pass_reason_color(PassReason reason, const Theme& theme);
/// The color of wrongly rejected pairs: an alarm color.
Rgba8 wrong_rejection_color(const Theme& theme);

/// The relative change: "+9.6 %", "−3.9 %"; a dash if `from` is 0.
std::string change_text(std::uint64_t from, std::uint64_t to);

Picture compose(const InspectFigure& figure, int width, int height, Overlay& overlay);

}  // namespace scb::render
