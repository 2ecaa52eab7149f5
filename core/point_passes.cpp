#include "core/point_passes.h"

#include <algorithm>
#include <cstring>

namespace scb {
namespace {

constexpr std::size_t width = 4;
using Lanes = double __attribute__((vector_size(width * sizeof(double))));

inline void load(Lanes& lanes, const double* from) { std::memcpy(&lanes, from, sizeof(Lanes)); }

inline double largest(const Lanes& v) {
    return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}
inline double smallest(const Lanes& v) {
    return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
}

inline double squared_distance(const PointsView& p, std::size_t i, const Vec3& c) {
    const double x = p.x[i] - c[0], y = p.y[i] - c[1], z = p.z[i] - c[2];
    return x * x + y * y + z * z;
}

}  // namespace

double max_squared_distance(const PointsView& points, const Vec3& c) {
    Lanes best = {};
    std::size_t i = 0;
    for (; i + width <= points.size; i += width) {
        Lanes x, y, z;
        load(x, points.x + i);
        load(y, points.y + i);
        load(z, points.z + i);
        x -= c[0];
        y -= c[1];
        z -= c[2];
        const Lanes d = x * x + y * y + z * z;
        best = d > best ? d : best;
    }
    double result = largest(best);
    for (; i < points.size; ++i) result = std::max(result, squared_distance(points, i, c));
    return result;
}

std::size_t extend(Interval& interval, const PointsView& points, const Vec3& c, const Vec3& n,
                   double enough) {
    constexpr std::size_t block = 64;
    std::size_t i = 0;
    while (i + width <= points.size) {
        if (interval.width() >= enough) return i;
        const std::size_t end = std::min(points.size, i + block);
        Lanes lower = Lanes{} + interval.lower, upper = Lanes{} + interval.upper;
        for (; i + width <= end; i += width) {
            Lanes x, y, z;
            load(x, points.x + i);
            load(y, points.y + i);
            load(z, points.z + i);
            const Lanes h = n[0] * (x - c[0]) + n[1] * (y - c[1]) + n[2] * (z - c[2]);
            lower = h < lower ? h : lower;
            upper = h > upper ? h : upper;
        }
        interval.lower = smallest(lower);
        interval.upper = largest(upper);
    }
    for (; i < points.size; ++i) {
        const double h =
            n[0] * (points.x[i] - c[0]) + n[1] * (points.y[i] - c[1]) + n[2] * (points.z[i] - c[2]);
        interval.lower = std::min(interval.lower, h);
        interval.upper = std::max(interval.upper, h);
    }
    return points.size;
}

Farthest farthest_point(const PointsView& points, const Vec3& c) {
    Farthest result;
    for (std::size_t i = 0; i < points.size; ++i) {
        const double d = squared_distance(points, i, c);
        if (d > result.squared_distance) result = {i, d};
    }
    return result;
}

}  // namespace scb
