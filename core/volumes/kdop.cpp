#include "scb/kdop.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scb {
namespace {

Vec3 dop_direction(int i) {
    const auto& d = dop_directions[static_cast<std::size_t>(i)];
    return {d[0], d[1], d[2]};
}

/// A face's plane: normal.p <= offset. The normal's coordinates are small whole numbers.
struct Plane {
    Vec3 normal;
    double offset;
};

/// Of 2 * count planes; the upper one of a slab has an even number, its lower one the next.
Plane plane(const DopSlabs& slabs, int i) {
    const Vec3 normal = dop_direction(slabs.which[i / 2]);
    if (i % 2 == 0) return {normal, slabs.upper[i / 2]};
    return {-normal, -slabs.lower[i / 2]};
}

}  // namespace

Vec3 farthest_corner(const DopSlabs& slabs, const Vec3& d) {
    // The direction as a sum of three faces' normals, with weights of 0 or more. The corner of
    // these faces reaches as far along it as the polytope or farther, and no farther once no face
    // cuts it off (Dantzig's simplex method, on the dual).
    std::array<Plane, 3> basis;
    double weights[3];
    for (int i = 0; i < 3; ++i) {
        basis[static_cast<std::size_t>(i)] = plane(slabs, d[i] < 0 ? 2 * i + 1 : 2 * i);
        weights[i] = std::abs(d[i]);
    }
    double size = 0;
    for (int i = 0; i < 3; ++i)
        size = std::max({size, std::abs(slabs.lower[i]), std::abs(slabs.upper[i])});
    const double slop = 0x1p-48 * size;
    // Each step takes the corner nearer, or ties; the bound is for ties that would go round.
    constexpr int most_steps = 32;
    Vec3 corner;
    for (int step = 0;; ++step) {
        // Columns of the inverse, times the determinant: whole numbers.
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
        const Plane entering = plane(slabs, beyond_all);
        double least = HUGE_VAL, shares[3];
        std::size_t leaving = 3;
        for (std::size_t i = 0; i < 3; ++i) {
            shares[i] = dot(entering.normal, columns[i]) / determinant;
            if (shares[i] > 0 && weights[i] / shares[i] < least) {
                least = weights[i] / shares[i];
                leaving = i;
            }
        }
        if (leaving == 3) return corner;  // no points at all
        for (std::size_t i = 0; i < 3; ++i)
            weights[i] = std::max(0.0, weights[i] - least * shares[i]);
        weights[leaving] = least;
        basis[leaving] = entering;
    }
}

SurfaceMeasures polytope_measures(const DopSlabs& slabs) {
    const Vec3 lower(slabs.lower[0], slabs.lower[1], slabs.lower[2]),
        upper(slabs.upper[0], slabs.upper[1], slabs.upper[2]);
    const Vec3 center = 0.5 * (lower + upper);
    const double size = std::sqrt(squared_norm(Vec3(upper - lower)));
    SurfaceMeasures sum{0, 0};
    std::vector<Vec3> face, kept;
    for (int i = 0; i < 2 * slabs.count; ++i) {
        const Plane own = plane(slabs, i);
        const double length = std::sqrt(squared_norm(own.normal));
        const Vec3 normal = own.normal / length;
        const double height = (own.offset - dot(own.normal, center)) / length;
        // A square in the face's plane, larger than the box; then what the other faces leave of it.
        const Vec3 across = std::abs(normal[0]) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
        Vec3 u = cross(normal, across);
        u *= size / std::sqrt(squared_norm(u));
        const Vec3 v = cross(normal, u), middle = height * normal;
        face = {middle + u + v, middle - u + v, middle - u - v, middle + u - v};
        for (int j = 0; j < 2 * slabs.count && !face.empty(); ++j) {
            if (j == i) continue;
            const Plane other = plane(slabs, j);
            const double offset = other.offset - dot(other.normal, center);
            const auto is_beyond = [&](const Vec3& p) { return dot(other.normal, p) > offset; };
            if (std::none_of(face.begin(), face.end(), is_beyond)) continue;
            kept.clear();
            for (std::size_t k = 0; k < face.size(); ++k) {
                const Vec3 &a = face[k], &b = face[(k + 1) % face.size()];
                const double at_a = dot(other.normal, a) - offset,
                             at_b = dot(other.normal, b) - offset;
                if (at_a <= 0) kept.push_back(a);
                if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
                    kept.push_back(a + at_a / (at_a - at_b) * (b - a));
            }
            face.swap(kept);
        }
        double doubled = 0;
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
            doubled += dot(normal, cross(Vec3(face[k] - face[0]), Vec3(face[k + 1] - face[0])));
        const double area = std::abs(doubled) / 2;
        sum.area += area;
        sum.volume += area * height / 3;
    }
    return sum;
}

}  // namespace scb
