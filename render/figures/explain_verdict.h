#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/figures/explain_figure.h"
#include "render/overlay/font_face.h"

namespace scb::render {

/// The step that a figure shows: the one that decided, or came closest.
const OverlapStep& shown_step(const ExplainFigure& figure);

/// "disjoint, 0.0123 apart".
std::string exact_words(const ContactCertificate& certificate);

/// A line of a figure's conclusions.
struct VerdictLine {
    std::string text;
    Rgba8 color;
    FontWeight weight = FontWeight::regular;
    std::optional<Rgba8> swatch{};
};

/// How the test ended, the exact answer, the verdict on the test's answer; the two volumes; the
/// other tests.
std::vector<VerdictLine> verdict_lines(const ExplainFigure& figure);

/// Draws them into the rectangle, wrapped; lines that do not fit are left out.
void draw_verdict(Overlay& overlay, const PixelRect& box, const ExplainFigure& figure, int unit);

}  // namespace scb::render
