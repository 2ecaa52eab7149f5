#include "scb/convex.h"

#include "core/volumes/direction_grid.h"
#include "core/volumes/polytope.h"

namespace scb {

std::span<const Vec3> touching_directions() {
    static const DirectionGrid grid = direction_grid(4);
    return grid.directions;
}

SurfaceMeasures touching_measures(std::span<const double> supports, double size) {
    std::vector<FacePlane> planes;
    for (std::size_t i = 0; i < supports.size(); ++i)
        planes.push_back({touching_directions()[i], supports[i]});
    return polytope_measures(planes, size);
}

}  // namespace scb
