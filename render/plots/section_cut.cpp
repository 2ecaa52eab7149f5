#include "render/plots/section_cut.h"

#include <algorithm>

namespace scb::render {

SectionCut section_cut(const AnyVolume& volume, const Vec3& from_a, const SectionPlane& plane,
                       double before, Rgba8 color) {
    SectionCut cut;
    cut.x = dot(plane.right, from_a);
    cut.y = dot(plane.up, from_a);
    cut.color = color;
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
    // Two points in one place.
    if (!std::isfinite(pixels)) pixels = 1;
}

ScreenCircle SectionScale::circle(const SectionCut& cut) const {
    return {at(cut.x, cut.y), pixels * cut.r};
}

HalfPlane SectionScale::side(const SectionCut& cut, double k, double sign) const {
    const ScreenPosition n = {sign * cut.nx, -sign * cut.ny}, c = at(cut.x, cut.y);
    return {n, n.x * c.x + n.y * c.y + k * pixels};
}

}  // namespace scb::render
