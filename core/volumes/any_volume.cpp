#include "core/volumes/any_volume.h"

#include "core/volumes/measured_shape.h"

namespace scb {

Vec3 center(const AnyVolume& volume) {
    return std::visit(
        []<class V>(const V& v) -> Vec3 {
            if constexpr (std::is_same_v<V, ConvexShape>)
                return v.center;
            else
                return support_center(v);
        },
        volume);
}

VolumeSize size_of(const ConvexShape& shape) {
    const VolumeLengths lengths = lengths_of(shape);
    const SurfaceMeasures measures =
        polytope_measures(planes_about(shape, touching_directions()), lengths.diameter);
    return {lengths, measures.area, measures.volume};
}

}  // namespace scb
