#pragma once

#include <optional>
#include <string>

#include "core/explain/overlap_steps.h"
#include "core/volumes/any_volume.h"

namespace scb::render {

/// The plane in which a step of an overlap test is drawn, in A's frame. Up is the step's separating
/// direction, so that A is below and B above.
struct SectionPlane {
    Vec3 right = Vec3::UnitX(), up = Vec3::UnitZ();
    Vec3 front = -Vec3::UnitY();  ///< towards the viewer
    /// How far the plane that cuts A, or B, is in front of its center. One plane cuts both, unless
    /// they are drawn as seen along `front`. Then each is cut through its own center; this cut is
    /// its silhouette, since the plane contains both normals.
    double before_a = 0, before_b = 0;
    std::string words;  ///< "cut by the plane of n0 and the line of centers"
};

/// Whether the plane cuts such a volume: a ball or slab cut ball. For others the drawing has the
/// silhouette, seen along `front`, whose extents are the volume's.
bool is_cut(const AnyVolume& volume);

/// For volumes that are not cut, the plane of the step's direction and the line of centers. Else
/// the plane that shows true lengths of the step and the most of the volumes. For slabs and
/// cylinders, and for an SCB's own extent, this is the plane of both normals. For a slab and a
/// ball, it is the plane of the normal through the ball's center and a common point (from the
/// center of A), if given, or else the other center. `b` is in A's frame.
SectionPlane section_plane(const AnyVolume& a, const AnyVolume& b, const OverlapStep& step,
                           const std::optional<Vec3>& common_point);

}  // namespace scb::render
