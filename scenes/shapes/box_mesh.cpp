#include <algorithm>
#include <array>

#include "scenes/shapes/parameter_checks.h"
#include "scenes/shapes/procedural.h"

namespace scb::scenes {

Mesh box_mesh(const BoxShape& shape) {
    for (int axis = 0; axis < 3; ++axis) require_length("size", shape.size[axis]);
    require_between("subdivisions", shape.subdivisions, 1, 512);
    const int n = shape.subdivisions;

    // Three integer coordinates identify a lattice point on the surface, for all sides that share
    // it.
    using Lattice = std::array<int, 3>;
    std::vector<Lattice> points;
    for (int z = 0; z <= n; ++z)
        for (int y = 0; y <= n; ++y)
            for (int x = 0; x <= n; x += (z % n == 0 || y % n == 0) ? 1 : n)
                points.push_back({z, y, x});
    const auto index = [&points](const Lattice& p) {
        const Lattice key{p[2], p[1], p[0]};
        return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), key) -
                                          points.begin());
    };

    Mesh mesh;
    mesh.vertices.reserve(points.size());
    for (const auto& [z, y, x] : points) {
        // This makes opposite sides exact mirror images.
        const Vec3 unit(2 * x - n, 2 * y - n, 2 * z - n);
        mesh.vertices.push_back((shape.size.array() * unit.array() / (2 * n)).matrix());
    }
    mesh.triangles.reserve(static_cast<std::size_t>(12) * static_cast<std::size_t>(n) *
                           static_cast<std::size_t>(n));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const bool upper : {false, true}) {
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    Lattice p{};
                    p[axis] = upper ? n : 0;
                    const auto corner = [&](int du, int dv) {
                        p[u] = i + du;
                        p[v] = j + dv;
                        return index(p);
                    };
                    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                                        d = corner(0, 1);
                    if (upper) {
                        mesh.triangles.push_back({a, b, c});
                        mesh.triangles.push_back({a, c, d});
                    } else {
                        mesh.triangles.push_back({a, c, b});
                        mesh.triangles.push_back({a, d, c});
                    }
                }
            }
        }
    }
    return mesh;
}

}  // namespace scb::scenes
