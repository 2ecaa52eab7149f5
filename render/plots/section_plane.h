#pragma once

#include <optional>
#include <string>

#include "core/explain/overlap_steps.h"
#include "render/view/any_volume.h"

namespace scb::render {

/// How a step of an overlap test is drawn in a plane, in A's frame. Up is the direction along which
/// the step separates, so that A is below and B above.
struct SectionPlane {
    Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ();
    Vec3 front = -Vec3::UnitY();  ///< towards the viewer
    /// How far the plane that cuts A, or B, is in front of its center. One plane cuts both, unless
    /// they are drawn as seen along `front`: then each is cut through its own center, which is its
    /// silhouette, since the plane holds both normals.
    double before_a = 0, before_b = 0;
    std::string words;  ///< "cut by the plane of n0 and the line of centers"
};

/// Whether the plane cuts such a volume, a ball or slab cut ball; of others it shows the
/// silhouette, seen along `front`, whose extents are those of the volume.
bool is_cut(const AnyVolume& volume);

/// Of volumes that are not cut the plane of the step's direction and the line of centers. Else the
/// plane in which the step's lengths are true and most is to be seen: of slabs and cylinders,
/// and of an SCB's own extent, that of both normals; else, of a slab and a ball, that of the normal
/// through the ball's center and a point of both volumes, where one is given (from the center of
/// A), or else the other center. `b` is in A's frame.
SectionPlane section_plane(const AnyVolume& a, const AnyVolume& b, const OverlapStep& step,
                           const std::optional<Vec3>& common_point);

}  // namespace scb::render
