#include "core/volumes/direction_grid.h"

#include <cmath>

#include <map>

namespace scb {

DirectionGrid direction_grid(int steps) {
    DirectionGrid grid;
    std::map<std::array<int, 3>, std::uint32_t> known;
    // Points are keyed by integers from -steps to steps, so that faces share the points of common
    // edges.
    const auto at = [&](int axis, int side, int i, int j) {
        std::array<int, 3> corner{};
        const auto a = static_cast<std::size_t>(axis);
        corner[a] = side * steps;
        corner[(a + 1) % 3] = 2 * i - steps;
        corner[(a + 2) % 3] = side * (2 * j - steps);
        const auto [found, is_new] =
            known.try_emplace(corner, static_cast<std::uint32_t>(grid.directions.size()));
        if (is_new) {
            const Vec3 d(corner[0], corner[1], corner[2]);
            grid.directions.push_back(d / std::sqrt(squared_norm(d)));
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {1, -1})
            for (int i = 0; i < steps; ++i)
                for (int j = 0; j < steps; ++j) {
                    const std::uint32_t a = at(axis, side, i, j), b = at(axis, side, i + 1, j),
                                        c = at(axis, side, i + 1, j + 1),
                                        d = at(axis, side, i, j + 1);
                    grid.triangles.push_back({a, b, c});
                    grid.triangles.push_back({a, c, d});
                }
    return grid;
}

}  // namespace scb
