#include "render/plots/section_cut.h"

#include <algorithm>

#include "core/base/portable_math.h"

namespace scb::render {
namespace {

// Enough that a box has visible corners, and a curve is smooth at the size of pictures.
constexpr std::size_t silhouette_directions = 240;

}  // namespace

ScreenPosition silhouette_direction(std::size_t i, std::size_t count) {
    const SinCos angle =
        sin_cos_degrees(360.0 * static_cast<double>(i) / static_cast<double>(count));
    return {angle.cos, angle.sin};
}

SectionCut section_cut(const AnyVolume& volume, const Vec3& from_a, const SectionPlane& plane,
                       double before, Rgba8 color) {
    SectionCut cut;
    cut.x = dot(plane.right, from_a);
    cut.y = dot(plane.up, from_a);
    cut.color = color;
    if (!is_cut(volume)) {
        for (std::size_t i = 0; i < silhouette_directions; ++i) {
            const ScreenPosition d = silhouette_direction(i, silhouette_directions);
            const Vec3 direction = d.x * plane.right + d.y * plane.up;
            cut.reaches.push_back(reach(volume, direction) - dot(center(volume), direction));
            cut.r = std::max(cut.r, cut.reaches.back());
        }
        return cut;
    }
    double r = 0;
    if (const Ball* ball = std::get_if<Ball>(&volume)) r = ball->radius;
    if (const Scb* s = std::get_if<Scb>(&volume)) {
        r = s->r;
        cut.has_slab = true;
        cut.nx = dot(plane.right, s->n);
        cut.ny = dot(plane.up, s->n);
        const double towards = before * dot(plane.front, s->n);
        cut.e = s->e - towards;
        cut.f = s->f - towards;
    }
    cut.r = std::abs(before) < r ? std::sqrt((r - before) * (r + before)) : 0;
    return cut;
}

ScreenPosition nearest_point(const SectionCut& cut, double sign, bool cylinder) {
    if (cut.is_silhouette()) {
        // The support's derivative is the sideways distance of its point from the center.
        const std::size_t count = cut.reaches.size(), at = sign > 0 ? count / 4 : 3 * count / 4;
        const double step = 2 * silhouette_direction(1, count).y;
        return {cut.x - sign * (cut.reaches[at + 1] - cut.reaches[at - 1]) / step,
                cut.y + sign * cut.reaches[at]};
    }
    ScreenPosition best = {cut.x, cut.y + sign * cut.r};
    if (!cut.has_slab || !(cut.normal_length() > 1 - 1e-9)) return best;
    const double pole = cut.ny * sign * cut.r;
    if (!cylinder && pole <= cut.e && pole >= cut.f) return best;
    best.y = -sign * HUGE_VAL;
    for (const double k : {cut.e, cut.f}) {
        const double half = cylinder ? cut.r : std::sqrt(std::max(0.0, cut.r * cut.r - k * k));
        for (const double side : {-half, half}) {
            const double x = cut.x + k * cut.nx - side * cut.ny,
                         y = cut.y + k * cut.ny + side * cut.nx;
            if (sign * y > sign * best.y) best = {x, y};
        }
    }
    return best;
}

void SectionExtent::add(double x, double y, double r) {
    left = std::min(left, x - r);
    right = std::max(right, x + r);
    bottom = std::min(bottom, y - r);
    top = std::max(top, y + r);
}

SectionScale::SectionScale(const PixelRect& box, const SectionExtent& shown) : rect(box) {
    x0 = (shown.left + shown.right) / 2;
    y0 = (shown.bottom + shown.top) / 2;
    const double width = shown.right - shown.left, height = shown.top - shown.bottom;
    pixels = std::min(width > 0 ? 0.9 * box.width / width : HUGE_VAL,
                      height > 0 ? 0.9 * box.height / height : HUGE_VAL);
    // Two coincident points.
    if (!std::isfinite(pixels)) pixels = 1;
}

ScreenCircle SectionScale::circle(const SectionCut& cut) const {
    return {at(cut.x, cut.y), pixels * cut.r};
}

HalfPlane SectionScale::side(const SectionCut& cut, double k, double sign) const {
    const ScreenPosition n = {sign * cut.nx, -sign * cut.ny}, c = at(cut.x, cut.y);
    return {n, n.x * c.x + n.y * c.y + k * pixels};
}

HalfPlane SectionScale::side(const SectionCut& cut, std::size_t i) const {
    const ScreenPosition d = silhouette_direction(i, cut.reaches.size()), n = {d.x, -d.y},
                         c = at(cut.x, cut.y);
    return {n, n.x * c.x + n.y * c.y + pixels * cut.reaches[i]};
}

}  // namespace scb::render
