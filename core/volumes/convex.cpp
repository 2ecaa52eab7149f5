#include "scb/convex.h"

#include "core/volumes/direction_grid.h"

namespace scb {

std::span<const Vec3> touching_directions() {
    static const DirectionGrid grid = direction_grid(4);
    return grid.directions;
}

}  // namespace scb
