#pragma once

#include <cstdint>
#include <span>

#include "core/hierarchy/primitives.h"
#include "scb/simd_level.h"

namespace scb {

/// Orders a range of triangles so that its first and second part are cheap to bound, and returns
/// the size of the first. Returns 0 and leaves the range as it was if no division saves anything.
///
/// A division costs, for each half, its number of triangles times the squared sum of the sides of
/// their box: the surface area heuristic of Goldsmith and Salmon ("Automatic creation of object
/// hierarchies for ray tracing", 1987) with another measure. The sum is twice the box's mean width,
/// so its square is the area of the ball of equal mean width, up to a constant. It is also the
/// squared diagonal, which gives the area of the ball around the box, plus the area of the box. So
/// it suits volumes between a ball and a box. For a few triangles, every division of their order
/// along the three axes is tried. For more, the divisions between 32 equal intervals of their
/// centroids are tried (Wald, "On fast construction of SAH-based bounding volume hierarchies",
/// 2007). The first of equally cheap divisions is taken. A half has at least a tenth of the
/// triangles, rounded up, so that depth stays logarithmic.
using SahSplit = std::uint32_t (*)(std::span<std::uint32_t> range, const Primitives& primitives);

/// The split with the vector instructions of a level; the results are the same for all levels.
SahSplit sah_split_at(SimdLevel level);

}  // namespace scb
