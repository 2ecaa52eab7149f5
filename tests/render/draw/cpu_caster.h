#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/volumes/convex_shape.h"
#include "render/view/picture.h"

namespace scb::render {

/// A ray-caster of its own, in double precision and straight from the definitions of the volumes,
/// to compare the renderer with.

struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit
};

struct Span {
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
};

/// Cuts the span down to `lower <= offset + slope * t <= upper`.
inline void cut(Span& span, double offset, double slope, double lower, double upper) {
    if (slope == 0) {
        if (offset < lower || offset > upper) span = {1, 0};
        return;
    }
    const double a = (lower - offset) / slope, b = (upper - offset) / slope;
    span.entry = std::max(span.entry, std::min(a, b));
    span.exit = std::min(span.exit, std::max(a, b));
}

inline Span intersect(const Ray& ray, const Ball& ball) {
    const Vec3 to_origin = ray.origin - ball.center;
    const double b = dot(to_origin, ray.direction);
    const double discriminant = b * b - squared_norm(to_origin) + ball.radius * ball.radius;
    if (discriminant < 0) return {1, 0};
    return {-b - std::sqrt(discriminant), -b + std::sqrt(discriminant)};
}

inline Span intersect(const Ray& ray, const Scb& scb) {
    Span span = intersect(ray, Ball{scb.c, scb.r});
    cut(span, dot(scb.n, ray.origin - scb.c), dot(scb.n, ray.direction), scb.f, scb.e);
    return span;
}

inline Span intersect(const Ray& ray, const Scb2& scb) {
    Span span = intersect(ray, Ball{scb.c, scb.r});
    for (const Slab& slab : scb.slabs)
        cut(span, dot(slab.n, ray.origin - scb.c), dot(slab.n, ray.direction), slab.f, slab.e);
    return span;
}

inline Span intersect(const Ray& ray, const Obb& box) {
    Span span;
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = box.axes.col(i);
        cut(span, dot(axis, ray.origin - box.center), dot(axis, ray.direction), -box.half[i],
            box.half[i]);
    }
    return span;
}

/// Between the planes that touch it in 866 directions, which is a little more than it.
inline Span intersect(const Ray& ray, const ConvexShape& shape) {
    static const DirectionGrid grid = direction_grid(12);
    // Of volumes that differ in their centers.
    static std::map<std::array<double, 3>, std::vector<FacePlane>> known;
    std::vector<FacePlane>& planes = known[{shape.center[0], shape.center[1], shape.center[2]}];
    if (planes.empty())
        for (const Vec3& own : grid.directions) {
            const Vec3 d = rotate(shape.axes, own);
            planes.push_back({d, support(shape, d)});
        }
    Span span;
    for (const FacePlane& plane : planes)
        cut(span, dot(plane.normal, Vec3(ray.origin - shape.center)),
            dot(plane.normal, ray.direction), -HUGE_VAL, plane.offset);
    return span;
}

/// The ray through a point of a pane, in pixels from its top left corner.
inline Ray ray_through(const Pane& pane, double x, double y) {
    const Camera& camera = pane.camera;
    const PixelRect& v = pane.viewport;
    const double half_height = camera.orthographic
                                   ? camera.view_height / 2
                                   : std::tan(camera.vertical_fov * 3.14159265358979323846 / 360);
    const double across = (2 * x / v.width - 1) * half_height * v.width / v.height;
    const double up = (1 - 2 * y / v.height) * half_height;
    const Vec3 sideways = across * camera.axes.col(0) + up * camera.axes.col(1);
    if (camera.orthographic) return {camera.position + sideways, -camera.axes.col(2)};
    return {camera.position, (sideways - camera.axes.col(2)).normalized()};
}

struct Hit {
    std::uint32_t id = 0;
    double distance = std::numeric_limits<double>::infinity();
    double second = std::numeric_limits<double>::infinity();  // the next surface behind it
};

inline Hit cast(const Pane& pane, double x, double y) {
    const Ray ray = ray_through(pane, x, y);
    // Depth is measured along the view axis.
    const double nearest = pane.camera.near_distance / -dot(ray.direction, pane.camera.axes.col(2));
    const std::optional<FacePlane>& clip = pane.camera.clip;
    Hit hit;
    for (const VolumeInstance& instance : pane.volumes) {
        Span span =
            std::visit([&](const auto& volume) { return intersect(ray, volume); }, instance.volume);
        if (clip)
            cut(span, dot(clip->normal, ray.origin), dot(clip->normal, ray.direction), -HUGE_VAL,
                clip->offset);
        if (span.entry > span.exit) continue;
        const double distance = span.entry < nearest ? span.exit : span.entry;
        if (distance < nearest) continue;
        if (distance < hit.distance) {
            hit.second = hit.distance;
            hit.distance = distance;
            hit.id = instance.id;
        } else {
            hit.second = std::min(hit.second, distance);
        }
    }
    return hit;
}

/// By how much of its distance the renderer may show a surface in front of another: 31 millionths
/// for the ids, the rest for its single precision.
constexpr double order_tolerance = 3.3e-5;

/// The id at a point. Empty if the id changes within a hundredth of a pixel, or if a second surface
/// is closer behind than the renderer's tolerance.
inline std::optional<std::uint32_t> certain_id(const Pane& pane, double x, double y) {
    const Hit hit = cast(pane, x, y);
    if (hit.second < (1 + order_tolerance) * hit.distance) return std::nullopt;
    for (const double dx : {-0.01, 0.01})
        for (const double dy : {-0.01, 0.01})
            if (cast(pane, x + dx, y + dy).id != hit.id) return std::nullopt;
    return hit.id;
}

}  // namespace scb::render
