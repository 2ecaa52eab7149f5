#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "scb/any_hierarchy.h"
#include "scb/overlap_options.h"
#include "scb/pose.h"

namespace scb {

/// Level by level, from the roots down, how many pairs of a volume of A's level and one of B's, as
/// level_cover has them, overlap; of those only below pairs that overlap on the level above. Ends
/// with the first level of none, which shows a gap between the two; or with that of all leaves, or
/// before the first level of more than `most` pairs.
std::vector<std::size_t> level_overlaps(
    const TreeShape& a, const TreeShape& b,
    const std::function<bool(std::uint32_t, std::uint32_t)>& overlap, std::size_t most);

/// The same of two hierarchies of one type of volumes, by an overlap test.
std::vector<std::size_t> level_overlaps(const AnyHierarchy& a, const AnyHierarchy& b,
                                        const Pose& b_to_a, const OverlapOptions& test,
                                        std::size_t most);

}  // namespace scb
