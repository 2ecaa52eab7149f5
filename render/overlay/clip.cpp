#include "render/overlay/clip.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace scb::render {
namespace {

double length_of(const ScreenPosition& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

ScreenPosition middle_of(const PixelRect& rect) {
    return {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
}

/// The unit directions from a circle's center in which the circle may meet the rectangle, in order,
/// and whether they go all around.
struct Directions {
    std::vector<ScreenPosition> units;
    bool all_around;
};

Directions directions_of(const ScreenCircle& circle, const PixelRect& rect) {
    const ScreenPosition middle = middle_of(rect),
                         to = {middle.x - circle.center.x, middle.y - circle.center.y};
    const double distance = length_of(to),
                 diagonal = length_of({double(rect.width), double(rect.height)});
    Directions result;
    // Steps that leave a tenth of a pixel between the circle and its tangents or chords.
    constexpr int steps = 720, arc_steps = 256;
    result.all_around = distance < 2 * diagonal;
    if (result.all_around) {
        for (int i = 0; i < steps; ++i) {
            const SinCos angle = sin_cos_turns(static_cast<double>(i) / steps);
            result.units.push_back({angle.cos, angle.sin});
        }
        return result;
    }
    const ScreenPosition ahead = {to.x / distance, to.y / distance};
    const double widest = diagonal / distance;
    for (int i = -arc_steps; i <= arc_steps; ++i) {
        const double across = widest * i / arc_steps, scale = 1 / std::sqrt(1 + across * across);
        result.units.push_back(
            {scale * (ahead.x - across * ahead.y), scale * (ahead.y + across * ahead.x)});
    }
    return result;
}

/// Cuts the segment to its part at or below a limit; false if there is none.
bool cut(double from, double to, double limit, double& begin, double& end) {
    if (from > limit && to > limit) return false;
    const double at = from != to ? (limit - from) / (to - from) : 0;
    if (from > limit) begin = std::max(begin, at);
    if (to > limit) end = std::min(end, at);
    return begin <= end;
}

}  // namespace

ScreenPolygon polygon_of(const PixelRect& rect) {
    const double left = rect.x, top = rect.y, right = rect.x + rect.width,
                 bottom = rect.y + rect.height;
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

ScreenPolygon clipped(const ScreenPolygon& polygon, const HalfPlane& half_plane) {
    ScreenPolygon result;
    const auto outside = [&](const ScreenPosition& p) {
        return half_plane.normal.x * p.x + half_plane.normal.y * p.y - half_plane.limit;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ScreenPosition &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = outside(p), at_q = outside(q);
        if (at_p <= 0) result.push_back(p);
        if ((at_p <= 0) == (at_q <= 0)) continue;
        const double t = at_p / (at_p - at_q);
        result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
    return result;
}

ScreenPolygon clipped(const ScreenPolygon& polygon, const ScreenCircle& disc,
                      const PixelRect& rect) {
    const Directions directions = directions_of(disc, rect);
    // A disc so far away that none of its directions leads here.
    const ScreenPosition middle = middle_of(rect);
    const double away = length_of({middle.x - disc.center.x, middle.y - disc.center.y});
    if (away - disc.radius > length_of({double(rect.width), double(rect.height)})) return {};
    ScreenPolygon result = polygon;
    for (const ScreenPosition& unit : directions.units)
        result =
            clipped(result, {unit, unit.x * disc.center.x + unit.y * disc.center.y + disc.radius});
    return result;
}

std::vector<std::vector<ScreenPosition>> clipped(const std::vector<ScreenPosition>& line,
                                                 const PixelRect& rect) {
    const double left = rect.x, top = rect.y, right = rect.x + rect.width,
                 bottom = rect.y + rect.height;
    std::vector<std::vector<ScreenPosition>> parts;
    bool open = false;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const ScreenPosition &p = line[i - 1], &q = line[i];
        double begin = 0, end = 1;
        const bool visible = cut(p.x, q.x, right, begin, end) &&
                             cut(-p.x, -q.x, -left, begin, end) &&
                             cut(p.y, q.y, bottom, begin, end) && cut(-p.y, -q.y, -top, begin, end);
        if (!visible) {
            open = false;
            continue;
        }
        const auto at = [&](double t) {
            return ScreenPosition{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
        };
        if (!open || begin > 0) parts.push_back({at(begin)});
        parts.back().push_back(at(end));
        open = end == 1;
    }
    return parts;
}

std::vector<ScreenPosition> circle_points(const ScreenCircle& circle, const PixelRect& rect) {
    const Directions directions = directions_of(circle, rect);
    std::vector<ScreenPosition> points;
    for (const ScreenPosition& unit : directions.units)
        points.push_back(
            {circle.center.x + circle.radius * unit.x, circle.center.y + circle.radius * unit.y});
    if (directions.all_around) points.push_back(points.front());
    return points;
}

}  // namespace scb::render
