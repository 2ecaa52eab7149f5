#pragma once

#include <span>
#include <string>

#include "core/model/node_volume.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// How far axes and normals of an engine may be from unit vectors at right angles.
inline constexpr double axes_tolerance = 1e-4;

/// The volume that the numbers are. `directions`: those of the tree, for its k-DOPs. Where they are
/// none, it has no volume, and `fault` says why, as a clause; else `fault` is empty.
NodeVolume node_volume(const RecordedVolume& recorded, std::span<const double> directions,
                       std::string& fault);

/// The largest |number| of the volume that is a length, not a direction; 0 where there is none.
double reach_of(const RecordedVolume& recorded, std::span<const double> directions);

}  // namespace scb::scenes
