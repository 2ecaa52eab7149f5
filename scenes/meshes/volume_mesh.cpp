#include "scenes/meshes/volume_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/trigonometry.h"

namespace scb::scenes {
namespace {

// Two unit vectors that make a right-handed frame with n.
std::pair<Vec3, Vec3> frame_about(const Vec3& n) {
    const int smallest = std::abs(n[0]) <= std::abs(n[1]) && std::abs(n[0]) <= std::abs(n[2]) ? 0
                         : std::abs(n[1]) <= std::abs(n[2])                                   ? 1
                                                                                              : 2;
    const Vec3 side = cross(n, Vec3(Vec3::Unit(smallest)));
    const Vec3 u = side / std::sqrt(squared_norm(side));
    return {u, cross(n, u)};
}

std::uint32_t next_index(const Mesh& mesh) {
    return static_cast<std::uint32_t>(mesh.vertices.size());
}

/// Lengths up to this cannot be told from 0 in coordinates of this size.
double resolution(const Vec3& center, double size) {
    return 1e-12 * (center.cwiseAbs().maxCoeff() + size);
}

}  // namespace

Mesh volume_mesh(const Scb& s, int segments) {
    Mesh mesh;
    const double least = resolution(s.c, s.r);
    if (!(s.r > least) || s.f > s.r || s.e < -s.r) return mesh;
    const double top = std::min(s.e, s.r), bottom = std::max(s.f, -s.r);
    const std::pair<Vec3, Vec3> axes = frame_about(s.n);
    const Vec3 &u = axes.first, &v = axes.second;
    const auto corners = static_cast<std::uint32_t>(segments);

    // Circles of latitude from the bottom to the top. A cut through a pole has none, and the fan of
    // its middle reaches to the next circle.
    const double pole = std::max(1e-6 * s.r, least);
    const auto radius_at = [&](double height) {
        return std::sqrt(std::max(0.0, s.r * s.r - height * height));
    };
    std::vector<double> heights;
    if (radius_at(bottom) > pole) heights.push_back(bottom);
    const int belts = std::max(2, segments / 2);
    for (int i = 1; i < belts; ++i) {
        const double height = -s.r * sin_cos_turns(0.5 * i / belts).cos;
        if (bottom + pole < height && height + pole < top) heights.push_back(height);
    }
    const bool is_disc = !heights.empty() && top - heights.back() <= least;
    if (radius_at(top) > pole && !is_disc) heights.push_back(top);
    if (heights.empty()) return mesh;

    const std::uint32_t first_ring = next_index(mesh);
    for (const double height : heights) {
        for (int k = 0; k < segments; ++k) {
            const SinCos at = sin_cos_turns(static_cast<double>(k) / segments);
            mesh.vertices.push_back(s.c + height * s.n +
                                    radius_at(height) * (at.cos * u + at.sin * v));
        }
    }
    const auto fan = [&](double height, std::uint32_t rim, bool up) {
        const std::uint32_t middle = next_index(mesh);
        mesh.vertices.push_back(s.c + height * s.n);
        for (std::uint32_t k = 0; k < corners; ++k) {
            const std::uint32_t a = rim + k, b = rim + (k + 1) % corners;
            mesh.triangles.push_back(up ? Triangle{middle, a, b} : Triangle{middle, b, a});
        }
    };
    fan(bottom, first_ring, false);
    std::uint32_t below = first_ring;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const std::uint32_t above = below + corners;
        for (std::uint32_t k = 0; k < corners; ++k) {
            const std::uint32_t next = (k + 1) % corners;
            mesh.triangles.push_back({below + k, below + next, above + next});
            mesh.triangles.push_back({below + k, above + next, above + k});
        }
        below = above;
    }
    fan(top, below, true);
    return mesh;
}

Mesh volume_mesh(const Ball& ball, int segments) {
    return volume_mesh(Scb{ball.center, ball.radius, Vec3::UnitZ(), ball.radius, -ball.radius},
                       segments);
}

Mesh volume_mesh(const Obb& box, int) {
    Mesh mesh;
    const double least = resolution(box.center, box.half.maxCoeff());
    std::vector<Eigen::Index> thick, flat;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        (box.half[axis] > least ? thick : flat).push_back(axis);
    if (flat.size() > 1) return mesh;
    if (flat.size() == 1) {
        const Vec3 x = box.axes.col(thick[0]) * box.half[thick[0]],
                   y = box.axes.col(thick[1]) * box.half[thick[1]];
        for (const Vec3& side : {Vec3(-x - y), Vec3(x - y), Vec3(x + y), Vec3(y - x)})
            mesh.vertices.push_back(box.center + side);
        // The two sides are cut along different diagonals, so that every edge has two triangles.
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}};
        return mesh;
    }
    for (int i = 0; i < 8; ++i) {
        const Vec3 corner((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        mesh.vertices.push_back(box.center + box.axes * corner.cwiseProduct(box.half));
    }
    for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 4, 6, 2},
                                     {1, 3, 7, 5},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 2, 3, 1},
                                     {4, 5, 7, 6}}) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    }
    return mesh;
}

}  // namespace scb::scenes
