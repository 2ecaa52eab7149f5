#pragma once

#include <vector>

#include "core/analysis/outcome.h"
#include "core/hierarchy/tree_shape.h"
#include "scb/step.h"

namespace scb {

/// Which tests of a query count for a triangle.
enum class HeatOf {
    volumes,    ///< of two volumes, where the one of its own body holds the triangle
    triangles,  ///< of two triangles
    wasted,     ///< as volumes, of those that the division of a false pair led to: see PassCounts
};

/// For each volume test of a query whether the pair whose division led to it is false: no triangles
/// below it intersect.
std::vector<bool> wasted_tests(const Steps& steps, const Outcomes& outcomes);

/// For each triangle of A (`side` 0) or B (1), in how many tests of the query it took part.
/// `shape` is that of the body's tree; `wasted` are wasted_tests, where `of` asks for them.
std::vector<std::uint32_t> triangle_heat(const Steps& steps, const TreeShape& shape,
                                         std::size_t side, HeatOf of,
                                         const std::vector<bool>& wasted = {});

}  // namespace scb
