#include "scenes/volume_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/trigonometry.h"

namespace scb {
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

}  // namespace

Mesh volume_mesh(const Scb& s, int segments) {
    Mesh mesh;
    if (!(s.r > 0) || s.f > s.r || s.e < -s.r) return mesh;
    const double top = std::min(s.e, s.r), bottom = std::max(s.f, -s.r);
    const std::pair<Vec3, Vec3> axes = frame_about(s.n);
    const Vec3 &u = axes.first, &v = axes.second;
    const auto corners = static_cast<std::uint32_t>(segments);

    const auto ring = [&](double height) {
        const double radius = std::sqrt(std::max(0.0, s.r * s.r - height * height));
        const std::uint32_t first = next_index(mesh);
        for (int k = 0; k < segments; ++k) {
            const SinCos at = sin_cos_turns(static_cast<double>(k) / segments);
            mesh.vertices.push_back(s.c + height * s.n + radius * (at.cos * u + at.sin * v));
        }
        return first;
    };
    const auto cap = [&](double height, std::uint32_t rim, bool up) {
        const std::uint32_t middle = next_index(mesh);
        mesh.vertices.push_back(s.c + height * s.n);
        for (std::uint32_t k = 0; k < corners; ++k) {
            const std::uint32_t a = rim + k, b = rim + (k + 1) % corners;
            mesh.triangles.push_back(up ? Triangle{middle, a, b} : Triangle{middle, b, a});
        }
    };

    const std::uint32_t bottom_ring = ring(bottom);
    std::uint32_t below = bottom_ring;
    cap(bottom, bottom_ring, false);
    const auto belt_up_to = [&](double height) {
        const std::uint32_t above = ring(height);
        for (std::uint32_t k = 0; k < corners; ++k) {
            const std::uint32_t next = (k + 1) % corners;
            mesh.triangles.push_back({below + k, below + next, above + next});
            mesh.triangles.push_back({below + k, above + next, above + k});
        }
        below = above;
    };
    // The circles of latitude of the whole ball that lie between the cuts, then the upper cut.
    const int belts = std::max(2, segments / 2);
    for (int i = 1; i < belts; ++i) {
        const double height = -s.r * sin_cos_turns(0.5 * i / belts).cos;
        if (bottom < height && height < top) belt_up_to(height);
    }
    if (top > bottom) belt_up_to(top);
    cap(top, below, true);
    return mesh;
}

Mesh volume_mesh(const Ball& ball, int segments) {
    return volume_mesh(Scb{ball.center, ball.radius, Vec3::UnitZ(), ball.radius, -ball.radius},
                       segments);
}

Mesh volume_mesh(const Obb& box, int) {
    Mesh mesh;
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

}  // namespace scb
