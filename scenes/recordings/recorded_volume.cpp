#include "scenes/recordings/recorded_volume.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/geometry/convex_hull.h"
#include "scb/error.h"
#include "scb/mesh.h"

namespace scb::scenes {
namespace {

/// With more directions, the polytope of a node takes seconds.
constexpr std::size_t most_directions = 128;
/// The hull of more points is computed first.
constexpr std::size_t most_searched = 16;

Vec3 vector_at(std::span<const double> values, std::size_t at) {
    return {values[at], values[at + 1], values[at + 2]};
}

/// The number of values of a kind; nothing: any number of points.
std::optional<std::size_t> number_count(RecordedKind kind, std::size_t directions) {
    switch (kind) {
        case RecordedKind::none:
            return 0;
        case RecordedKind::aabb:
            return 6;
        case RecordedKind::obb:
            return 15;
        case RecordedKind::ball:
            return 4;
        case RecordedKind::capsule:
            return 7;
        case RecordedKind::rss:
            return 10;
        case RecordedKind::kdop:
            return 2 * directions;
        case RecordedKind::scb:
            return 9;
        case RecordedKind::scb2:
            return 14;
        case RecordedKind::hull:
            break;
    }
    return std::nullopt;
}

void require(bool condition, const char* fault) {
    if (!condition) throw InputError(fault);
}

void require_unit(const Vec3& v, const char* fault) {
    require(std::abs(squared_norm(v) - 1) < axes_tolerance, fault);
}

Slab slab_at(std::span<const double> values, std::size_t at, double radius) {
    const Slab slab{vector_at(values, at), values[at + 3], values[at + 4]};
    require_unit(slab.n, "its normal is no unit vector");
    require(slab.f <= slab.e, "its planes enclose no point");
    require(slab.e >= -radius && slab.f <= radius, "its planes cut away the whole ball");
    return {slab.n, std::min(slab.e, radius), std::max(slab.f, -radius)};
}

NodeVolume box_of(std::span<const double> v) {
    const Vec3 lower = vector_at(v, 0), upper = vector_at(v, 3);
    require((lower.array() <= upper.array()).all(), "its lower corner is above the upper one");
    if (lower.allFinite() && upper.allFinite()) return box_between(lower, upper);
    require((lower.array() < HUGE_VAL).all() && (upper.array() > -HUGE_VAL).all(),
            "a side of it begins where space ends");
    return OpenBox{lower, upper};
}

NodeVolume obb_of(std::span<const double> v) {
    Obb box{vector_at(v, 0), Mat3::Identity(), vector_at(v, 12)};
    for (int i = 0; i < 3; ++i) box.axes.col(i) = vector_at(v, 3 + 3 * static_cast<std::size_t>(i));
    const Mat3 off = box.axes.transpose() * box.axes - Mat3::Identity();
    require(off.cwiseAbs().maxCoeff() < axes_tolerance,
            "its axes are no unit vectors at right angles");
    require((box.half.array() >= 0).all(), "half a side is below 0");
    return box;
}

double radius_at(std::span<const double> v, std::size_t at) {
    require(v[at] >= 0, "its radius is below 0");
    return v[at];
}

NodeVolume rss_of(std::span<const double> v) {
    const Vec3 s = vector_at(v, 3) / 2, t = vector_at(v, 6) / 2;
    require(std::abs(dot(s, t)) <= axes_tolerance * std::sqrt(squared_norm(s) * squared_norm(t)),
            "its sides are not at right angles");
    return Rss{vector_at(v, 0) + s + t, {s, t}, radius_at(v, 9)};
}

NodeVolume scb2_of(std::span<const double> v) {
    Scb2 scb{vector_at(v, 0), radius_at(v, 3), {}};
    scb.slabs = {slab_at(v, 4, scb.r), slab_at(v, 9, scb.r)};
    require(std::abs(dot(scb.slabs[0].n, scb.slabs[1].n)) < axes_tolerance,
            "its normals are not at right angles");
    return scb;
}

NodeVolume hull_of(std::span<const double> v) {
    require(!v.empty() && v.size() % 3 == 0, "it has no whole number of points");
    std::vector<Vec3> points;
    Box box;
    for (std::size_t i = 0; i < v.size(); i += 3) {
        points.push_back(vector_at(v, i));
        box.add(points.back());
    }
    Polytope hull;
    hull.center = box.lower + (box.upper - box.lower) / 2;
    // Each search for a support point goes through all points.
    if (points.size() > most_searched) {
        std::vector<Vec3> vertices;
        for (const std::uint32_t i : convex_hull(points).vertices) vertices.push_back(points[i]);
        points = std::move(vertices);
    }
    for (const Vec3& point : points) hull.corners.push_back(point - hull.center);
    return std::make_shared<const Polytope>(std::move(hull));
}

NodeVolume made_volume(const RecordedVolume& recorded, std::span<const double> directions) {
    const std::span<const double> v = recorded.values;
    const auto count = number_count(recorded.kind, directions.size() / 3);
    if (count && v.size() != *count)
        throw InputError("it has " + std::to_string(v.size()) + " numbers in place of " +
                         std::to_string(*count));
    // The box of a plane has sides at infinity.
    const bool may_be_open = recorded.kind == RecordedKind::aabb;
    for (const double value : v)
        require(std::abs(value) <= max_coordinate || (may_be_open && std::isinf(value)),
                "one of its numbers is not finite or too large");
    switch (recorded.kind) {
        case RecordedKind::none:
            break;
        case RecordedKind::aabb:
            return box_of(v);
        case RecordedKind::obb:
            return obb_of(v);
        case RecordedKind::ball:
            return Ball{vector_at(v, 0), radius_at(v, 3)};
        case RecordedKind::capsule: {
            const Vec3 a = vector_at(v, 0), b = vector_at(v, 3);
            return Capsule{(a + b) / 2, (b - a) / 2, radius_at(v, 6)};
        }
        case RecordedKind::rss:
            return rss_of(v);
        case RecordedKind::kdop:
            require(directions.size() >= 3, "its tree names no directions");
            require(directions.size() <= 3 * most_directions, "its tree has too many directions");
            return std::make_shared<const Polytope>(slabs_polytope(directions, v));
        case RecordedKind::scb: {
            const Slab slab = slab_at(v, 4, radius_at(v, 3));
            return Scb{vector_at(v, 0), v[3], slab.n, slab.e, slab.f};
        }
        case RecordedKind::scb2:
            return scb2_of(v);
        case RecordedKind::hull:
            return hull_of(v);
    }
    return {};
}

}  // namespace

NodeVolume node_volume(const RecordedVolume& recorded, std::span<const double> directions,
                       std::string& fault) {
    fault.clear();
    try {
        return made_volume(recorded, directions);
    } catch (const InputError& error) {
        fault = error.what();
        return {};
    }
}

double reach_of(const RecordedVolume& recorded, std::span<const double> directions) {
    const std::span<const double> v = recorded.values;
    double reach = 0;
    const auto take = [&](std::size_t at, std::size_t count, double scale = 1) {
        for (std::size_t i = at; i < at + count && i < v.size(); ++i)
            if (std::isfinite(v[i])) reach = std::max(reach, std::abs(v[i]) * scale);
    };
    switch (recorded.kind) {
        case RecordedKind::obb:
            take(0, 3);
            take(12, 3);
            break;
        case RecordedKind::scb:
        case RecordedKind::scb2:
            take(0, 4);
            take(7, 2);
            take(12, 2);
            break;
        case RecordedKind::kdop:
            for (std::size_t i = 0; 3 * i + 2 < directions.size(); ++i)
                if (const double length = std::sqrt(squared_norm(vector_at(directions, 3 * i)));
                    length > 0)
                    take(2 * i, 2, 1 / length);
            break;
        default:
            take(0, v.size());
    }
    return reach;
}

}  // namespace scb::scenes
