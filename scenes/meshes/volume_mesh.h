#pragma once

#include "core/volumes/convex_shape.h"
#include "scb/ball.h"
#include "scb/mesh.h"
#include "scb/obb.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb::scenes {

/// The surface of a volume as triangles, for viewers that cannot draw it exactly: vertices lie on
/// the surface, so the mesh is inside the volume. A circle has `segments` (at least 3) corners; a
/// full ball has `segments / 2` belts, whose outer two are fans about its poles. Counterclockwise
/// seen from outside, closed, without triangles of two equal corners.
///
/// A flat SCB gives a disc seen from both sides, a flat box a rectangle, a flat ball with two slabs
/// the part of a disc in its second slab. Volumes without area give no triangles: a ball without
/// radius, an SCB that is cut away completely, a box that is a line or a point. Lengths below 1e-12
/// of the coordinates, and cuts closer than 1e-6 radii to a pole or to another circle, count as
/// zero. For a convex shape, the polytope of its faces, or of up to 866 faces that touch it; this
/// one contains it.
Mesh volume_mesh(const Scb& scb, int segments);
Mesh volume_mesh(const Scb2& scb, int segments);
Mesh volume_mesh(const Ball& ball, int segments);
Mesh volume_mesh(const Obb& box, int segments);
Mesh volume_mesh(const ConvexShape& shape, int segments);

}  // namespace scb::scenes
