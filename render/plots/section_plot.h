#pragma once

#include <optional>

#include "core/explain/contact_certificate.h"
#include "render/plots/section_plane.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace scb::render {

class Overlay;

/// A step of an overlap test of two slab cut balls or balls as a drawing, after Figures 7 and 9 of
/// the paper: their cuts with the section plane, their balls, the planes of their slabs, the
/// cylinder if there is one, and the terms of the slack, as lengths and numbers. For other volumes,
/// their silhouettes and the same numbers.
struct SectionPlot {
    AnyVolume a, b;  ///< in A's frame
    OverlapStep step;
    SectionPlane plane;
    std::optional<Vec3> common_point{};  ///< from the center of A, if known
    Rgba8 gap_color;                     ///< of the gap or overlap of the two extents

    bool has_cylinder() const;
    /// Whether the step measures B against A's slab.
    bool measures_b() const;
};

/// Draws it inside the rectangle. If one of the two, or the gap between them, is too small to see
/// and there is room, an inset magnifies it; returns whether there is one.
bool draw_section_plot(Overlay& overlay, const PixelRect& rect, const SectionPlot& plot,
                       const Theme& theme, int unit);

}  // namespace scb::render
