#include "core/fit/flat_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scb {

// Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979: a chain over the
// points in order, and one back. Returns how many corners there are.
std::size_t FlatHull::keep_corners(std::array<Point, 2 * FewPoints::capacity>& hull) {
    const auto begin = points_.begin();
    std::sort(begin, begin + static_cast<std::ptrdiff_t>(count_));
    const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    };
    std::size_t size = 0;
    const auto extend = [&](const Point& p, std::size_t least) {
        while (size > least && !turns_left(hull[size - 2], hull[size - 1], p)) --size;
        hull[size++] = p;
    };
    for (std::size_t i = 0; i < count_; ++i) extend(points_[i], 1);
    const std::size_t lower = size;
    for (std::size_t i = count_ - 1; i-- > 0;) extend(points_[i], lower);
    // The first point again.
    return count_ > 1 ? size - 1 : size;
}

std::array<double, 2> FlatHull::narrowest_direction() {
    std::array<Point, 2 * FewPoints::capacity> hull;
    const std::size_t size = keep_corners(hull);
    Point best = {1, 0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size; ++i) {
        const Point &a = hull[i], &b = hull[(i + 1) % size];
        const double x = b[0] - a[0], y = b[1] - a[1], length = std::sqrt(x * x + y * y);
        // Squares of shorter edges lose their digits to underflow.
        if (!(length > 1e-140)) continue;
        const Point across = {-y / length, x / length};
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
