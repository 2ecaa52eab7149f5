#pragma once

#include <span>
#include <string>

#include "core/model/node_volume.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// How far axes and normals of an engine may be from unit vectors at right angles.
inline constexpr double axes_tolerance = 1e-4;

/// The volume of recorded numbers. `directions`: the tree's directions, for k-DOPs. If the numbers
/// are invalid, there is no volume, and `fault` is the reason, as a clause; else `fault` is empty.
NodeVolume node_volume(const RecordedVolume& recorded, std::span<const double> directions,
                       std::string& fault);

/// The largest |number| of the volume that is a length, not a direction; 0 if there is none.
double reach_of(const RecordedVolume& recorded, std::span<const double> directions);

}  // namespace scb::scenes
