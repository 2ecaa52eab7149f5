#pragma once

#include "core/ball.h"
#include "core/mesh.h"
#include "core/obb.h"
#include "core/scb.h"

namespace scb {

/// The surface of a volume as triangles, for viewers that cannot draw it exactly: vertices lie on
/// the surface, so the mesh is inside the volume. `segments` (at least 3) corners to a circle; a
/// full ball has `segments / 2` belts. Counterclockwise seen from outside. A flat SCB gives a disc
/// seen from both sides; one that is cut away wholly, or has no radius, gives no triangles.
Mesh volume_mesh(const Scb& scb, int segments);
Mesh volume_mesh(const Ball& ball, int segments);
Mesh volume_mesh(const Obb& box, int segments);

}  // namespace scb
