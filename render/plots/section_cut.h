#pragma once

#include <cmath>
#include <vector>

#include "render/overlay/clip.h"
#include "render/plots/section_plane.h"
#include "render/view/palette.h"

namespace scb::render {

/// The cut of a section plane with a ball or slab cut ball, or the silhouette of another volume
/// seen along the plane's front, in plane coordinates from the center of A: x to the right, y up.
struct SectionCut {
    double x = 0, y = 0, r = 0;
    bool has_slab = false;
    double nx = 0, ny = 0, e = 0, f = 0;  ///< the slab: f <= nx dx + ny dy <= e
    Rgba8 color;
    /// For a silhouette: its extents from x, y in all directions of silhouette_direction; r is the
    /// largest.
    std::vector<double> reaches{};

    bool is_silhouette() const { return !reaches.empty(); }
    double normal_length() const { return std::sqrt(nx * nx + ny * ny); }
};

/// The i-th of `count` directions, from the right counterclockwise.
ScreenPosition silhouette_direction(std::size_t i, std::size_t count);

/// `from_a`: the volume's center, from the center of A; `before`: how far the plane is in front of
/// it. A plane that misses the ball gives radius 0.
SectionCut section_cut(const AnyVolume& volume, const Vec3& from_a, const SectionPlane& plane,
                       double before, Rgba8 color);

/// The point of a cut nearest to a body below it (`sign` -1) or above: the corner of its cylinder,
/// or of the slab and the circle; else the circle's pole. In plane coordinates.
ScreenPosition nearest_point(const SectionCut& cut, double sign, bool cylinder);

/// A part of the section plane.
struct SectionExtent {
    double left = HUGE_VAL, right = -HUGE_VAL, bottom = HUGE_VAL, top = -HUGE_VAL;

    void add(double x, double y, double r = 0);
};

/// From plane coordinates to pixels of a rectangle.
struct SectionScale {
    double x0 = 0, y0 = 0;  ///< the point in the middle of the rectangle
    double pixels = 1;      ///< per unit
    PixelRect rect;

    /// Shows the extent, with a margin.
    SectionScale(const PixelRect& box, const SectionExtent& shown);

    double px(double x) const { return rect.x + rect.width / 2.0 + pixels * (x - x0); }
    double py(double y) const { return rect.y + rect.height / 2.0 - pixels * (y - y0); }
    ScreenPosition at(double x, double y) const { return {px(x), py(y)}; }
    bool shows_height(double y) const { return py(y) >= rect.y && py(y) <= rect.y + rect.height; }
    ScreenCircle circle(const SectionCut& cut) const;
    /// The points at most k above the cut's center along its normal (`sign` 1), or below it (-1).
    HalfPlane side(const SectionCut& cut, double k, double sign) const;
    /// The points within a silhouette's extent in its i-th direction.
    HalfPlane side(const SectionCut& cut, std::size_t i) const;
};

}  // namespace scb::render
