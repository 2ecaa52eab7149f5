#pragma once

#include <cstdint>
#include <span>

#include "core/hierarchy/primitives.h"
#include "scb/simd_level.h"

namespace scb {

/// Orders a range of triangles so that a first part and a second are cheap to bound, and returns
/// the size of the first; 0, with the range as it was, where no division saves anything.
///
/// A division costs, for each half, its number of triangles times the squared sum of the sides of
/// their box: the surface area heuristic of Goldsmith and Salmon ("Automatic creation of object
/// hierarchies for ray tracing", 1987) with another measure. The sum is twice the box's mean width,
/// so this is the area of the ball of equal mean width, but for a constant; and it is the squared
/// diagonal, of which the area of the ball around the box is made, plus the area of the box, so
/// that volumes between a ball and a box are served by both. Up to a few triangles every division
/// of their order along the three axes is tried; of more those between 32 equal intervals of their
/// centroids (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007). Of
/// equally cheap ones the first.
/// A half has at least a tenth of the triangles, so that depth stays logarithmic, or one of fewer
/// than ten.
using SahSplit = std::uint32_t (*)(std::span<std::uint32_t> range, const Primitives& primitives);

/// The above with the vector instructions of a level: the same orders and sizes for any.
SahSplit sah_split_at(SimdLevel level);

}  // namespace scb
