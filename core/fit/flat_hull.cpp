#include "core/fit/flat_hull.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/fit/few_points.h"

namespace scb {
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
