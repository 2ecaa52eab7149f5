#include "scb/kdop.h"

#include <algorithm>
#include <cmath>

namespace scb {
namespace {

Vec3 dop_direction(int i) {
    const auto& d = dop_directions[static_cast<std::size_t>(i)];
    return {d[0], d[1], d[2]};
}

/// Plane i of 2 * count; the upper plane of a slab has an even number, its lower plane the next.
FacePlane plane(const DopSlabs& slabs, int i) {
    const Vec3 normal = dop_direction(slabs.which[i / 2]);
    if (i % 2 == 0) return {normal, slabs.upper[i / 2]};
    return {-normal, -slabs.lower[i / 2]};
}

}  // namespace

Vec3 farthest_corner(const DopSlabs& slabs, const Vec3& d) {
    // The direction as a sum of three faces' normals, with weights of 0 or more. The corner of
    // these faces reaches as far along it as the polytope or farther, and no farther once no face
    // cuts it off (Dantzig's simplex method, on the dual).
    std::array<FacePlane, 3> basis;
    double weights[3];
    for (int i = 0; i < 3; ++i) {
        basis[static_cast<std::size_t>(i)] = plane(slabs, d[i] < 0 ? 2 * i + 1 : 2 * i);
        weights[i] = std::abs(d[i]);
    }
    double size = 0;
    for (int i = 0; i < 3; ++i)
        size = std::max({size, std::abs(slabs.lower[i]), std::abs(slabs.upper[i])});
    const double slop = 0x1p-48 * size;
    // Each step moves the corner nearer, or ties; the bound ends ties that would cycle.
    constexpr int most_steps = 32;
    Vec3 corner;
    for (int step = 0;; ++step) {
        // Columns of the inverse, times the determinant: integers.
        const auto& [p, q, r] = basis;
        const Vec3 columns[3] = {cross(q.normal, r.normal), cross(r.normal, p.normal),
                                 cross(p.normal, q.normal)};
        const double determinant = dot(p.normal, columns[0]);
        corner =
            (p.offset * columns[0] + q.offset * columns[1] + r.offset * columns[2]) / determinant;
        if (step == most_steps) return corner;
        double most = slop;
        int beyond_all = -1;
        for (int i = 0; i < slabs.count; ++i) {
            const double along = dot(dop_direction(slabs.which[i]), corner);
            for (const bool upper : {true, false}) {
                const double beyond = upper ? along - slabs.upper[i] : slabs.lower[i] - along;
                if (!(beyond > most)) continue;
                most = beyond;
                beyond_all = 2 * i + (upper ? 0 : 1);
            }
        }
        if (beyond_all < 0) return corner;
        const FacePlane entering = plane(slabs, beyond_all);
        double least = HUGE_VAL, shares[3];
        std::size_t leaving = 3;
        for (std::size_t i = 0; i < 3; ++i) {
            shares[i] = dot(entering.normal, columns[i]) / determinant;
            if (shares[i] > 0 && weights[i] / shares[i] < least) {
                least = weights[i] / shares[i];
                leaving = i;
            }
        }
        if (leaving == 3) return corner;  // the polytope is empty
        for (std::size_t i = 0; i < 3; ++i)
            weights[i] = std::max(0.0, weights[i] - least * shares[i]);
        weights[leaving] = least;
        basis[leaving] = entering;
    }
}

std::vector<FacePlane> faces(const DopSlabs& slabs, const Vec3& center) {
    std::vector<FacePlane> planes;
    for (int i = 0; i < 2 * slabs.count; ++i) {
        planes.push_back(plane(slabs, i));
        planes.back().offset -= dot(planes.back().normal, center);
    }
    return planes;
}

}  // namespace scb
