#pragma once

#include <optional>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// The volume under the linear map `x -> map * x`, which may stretch, mirror or shear. A map that
/// keeps angles keeps the type, except for open boxes, which need a diagonal map. Any other map
/// takes boxes, hulls and k-DOPs to boxes or polytopes. `monostate` if no type fits: a sheared ball
/// is an ellipsoid.
NodeVolume mapped(const NodeVolume& volume, const Mat3& map);

/// All volumes of the tree, mapped.
EngineNodes mapped(EngineNodes tree, const Mat3& map);

/// The mesh with all its vertices mapped.
Mesh mapped(Mesh mesh, const Mat3& map);

/// The factor by which the map scales a volume; negative if it mirrors.
double determinant(const Mat3& map);

/// The factor by which the map scales all lengths; nothing if it does not keep angles up to
/// rounding.
std::optional<double> uniform_scale(const Mat3& map);

}  // namespace scb
