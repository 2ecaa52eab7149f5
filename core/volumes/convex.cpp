#include "scb/convex.h"

#include "core/volumes/direction_grid.h"

namespace scb {
namespace {

const DirectionGrid& measured() {
    static const DirectionGrid grid = direction_grid(4);
    return grid;
}

}  // namespace

std::span<const Vec3> measured_directions() { return measured().directions; }

SurfaceMeasures surface_measures(std::span<const Vec3> points) {
    SurfaceMeasures sum{0, 0};
    for (const auto& [i, j, k] : measured().triangles) {
        const Vec3 &a = points[i], &b = points[j], &c = points[k];
        const Vec3 normal = cross(Vec3(b - a), Vec3(c - a));
        sum.area += 0.5 * std::sqrt(squared_norm(normal));
        sum.volume += dot(a, normal) / 6;
    }
    return sum;
}

}  // namespace scb
