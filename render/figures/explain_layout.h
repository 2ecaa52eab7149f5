#pragma once

#include "render/figures/explain_figure.h"

namespace scb::render {

/// The positions of the parts of a picture of an explanation.
struct ExplainLayout {
    int unit = 20;  ///< size of body text, pixels
    PixelRect heading;
    PixelRect view, section;  ///< with their captions above them; boxes have no section
    PixelRect steps, verdict;
    PixelRect footnote;  ///< the meaning of symbols; empty if there are none, or no room

    static constexpr int caption_lines = 2;
    int caption_height() const { return caption_lines * unit * 5 / 4 + unit / 4; }
    /// The view of the scene, without its caption and the scale bar below it.
    PixelRect view_box() const;
};
ExplainLayout explain_layout(int width, int height, const ExplainFigure& figure, Overlay& overlay);

}  // namespace scb::render
