#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scb/vec.h"

namespace scb {

/// Unit directions over the whole sphere, and triangles between them, counterclockwise from
/// outside: a grid of `steps` by `steps` on each face of a cube, so 6 steps^2 + 2 directions. With
/// an even number of steps, these include the axes, edges and corners of the cube, the directions
/// of kdop.h. A support function maps the grid to a mesh of its volume.
struct DirectionGrid {
    std::vector<Vec3> directions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
DirectionGrid direction_grid(int steps);

}  // namespace scb
