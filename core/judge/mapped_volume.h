#pragma once

#include <optional>

#include "core/model/engine_nodes.h"
#include "scb/mesh.h"

namespace scb {

/// The volume of a body that a linear map stretches, mirrors or shears: `x -> map * x`. A map that
/// keeps angles takes each kind of volume to the same kind; any other takes boxes, hulls and k-DOPs
/// to polytopes. `monostate` for what is none of these: a ball under a shear is an ellipsoid.
NodeVolume mapped(const NodeVolume& volume, const Mat3& map);

/// All volumes of the tree, mapped.
EngineNodes mapped(EngineNodes tree, const Mat3& map);

/// All vertices of the mesh, mapped.
Mesh mapped(Mesh mesh, const Mat3& map);

/// By how much the map changes volumes; below 0 where it mirrors.
double determinant(const Mat3& map);

/// By how much the map scales all lengths alike; nothing where it does not keep angles, up to some
/// units in the last place.
std::optional<double> uniform_scale(const Mat3& map);

}  // namespace scb
