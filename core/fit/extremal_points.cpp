#include "core/fit/extremal_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace scb {
namespace {

// The ids met so far, and their indices: a hash table with open addressing and two and a half times
// the capacity.
struct MetIds {
    static constexpr std::size_t slots = 64;
    std::array<std::uint8_t, slots> index_plus_1{};
    std::array<std::size_t, slots> id;
};

std::int32_t index_of(std::size_t id, MetIds& met, const PointsView& by_id, FewPoints& points) {
    std::size_t slot = id % MetIds::slots;
    while (met.index_plus_1[slot] != 0) {
        if (met.id[slot] == id) return met.index_plus_1[slot] - 1;
        slot = (slot + 1) % MetIds::slots;
    }
    const std::size_t index = points.count;
    points.add(by_id.x[id], by_id.y[id], by_id.z[id]);
    met.id[slot] = id;
    met.index_plus_1[slot] = static_cast<std::uint8_t>(index + 1);
    return static_cast<std::int32_t>(index);
}

}  // namespace

void extremal_points(const Dop26& dop, const PointsView& by_id, FewPoints& points,
                     ExtremalPairs& pairs) {
    points.count = 0;
    MetIds met;
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        pairs.upper[i] = index_of(static_cast<std::size_t>(dop.upper_id[i]), met, by_id, points);
        pairs.lower[i] = index_of(static_cast<std::size_t>(dop.lower_id[i]), met, by_id, points);
    }
    points.pad();
}

namespace {

using Hull = std::array<FlatPoint, 2 * FewPoints::capacity>;

// Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979: a chain over the
// points in order, and one back. Returns the number of corners.
std::size_t corners_of(std::span<FlatPoint> points, Hull& hull) {
    std::sort(points.begin(), points.end());
    const auto turns_left = [](const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    };
    std::size_t size = 0;
    const auto extend = [&](const FlatPoint& p, std::size_t least) {
        while (size > least && !turns_left(hull[size - 2], hull[size - 1], p)) --size;
        hull[size++] = p;
    };
    for (const FlatPoint& p : points) extend(p, 1);
    if (points.size() < 2) return size;
    const std::size_t lower = size;
    for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], lower);
    return size - 1;  // without the first point at the end
}

}  // namespace

FlatPoint narrowest_direction(std::span<FlatPoint> points) {
    assert(points.size() <= FewPoints::capacity);
    Hull hull;
    const std::size_t size = corners_of(points, hull);
    FlatPoint best = {1, 0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size; ++i) {
        const FlatPoint &a = hull[i], &b = hull[(i + 1) % size];
        const double x = b[0] - a[0], y = b[1] - a[1], length = std::sqrt(x * x + y * y);
        // Squares of shorter edges lose their digits to underflow.
        if (!(length > 1e-140)) continue;
        const FlatPoint across = {-y / length, x / length};
        double width = 0;
        for (std::size_t j = 0; j < size; ++j)
            width =
                std::max(width, across[0] * (hull[j][0] - a[0]) + across[1] * (hull[j][1] - a[1]));
        if (width < least) {
            least = width;
            best = across;
        }
    }
    return best;
}

}  // namespace scb
