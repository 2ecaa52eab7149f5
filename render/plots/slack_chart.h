#pragma once

#include <string>
#include <vector>

#include "core/explain/overlap_steps.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace scb::render {

class Overlay;

/// The slack of every step of a test as bars about zero: steps that separate go to the right.
struct SlackChart {
    const OverlapSteps* steps = nullptr;
    Rgba8 separating;  ///< the color of bars that go to the right
};

/// The number of its lines; see slack_line.
int slack_chart_lines(const OverlapSteps& steps);
int slack_line(int unit);

/// Draws it inside the rectangle. Steps that do not fit are left out, and so are formulas without
/// room.
void draw_slack_chart(Overlay& overlay, const PixelRect& rect, const SlackChart& chart,
                      const Theme& theme, int unit);

}  // namespace scb::render
