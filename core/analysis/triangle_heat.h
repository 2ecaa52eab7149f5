#pragma once

#include <vector>

#include "core/analysis/attribution.h"
#include "core/analysis/outcome.h"
#include "core/hierarchy/tree_shape.h"
#include "scb/step.h"

namespace scb {

/// Which tests of a query count for a triangle.
enum class HeatOf {
    volumes,    ///< tests of two volumes, if the triangle is below the node of its body
    triangles,  ///< tests of two triangles
    wasted,     ///< as `volumes`, but only wasted tests: see PassCounts
};

/// For each volume test of a query, whether it is wasted: no triangles intersect below the pair
/// that led to it.
std::vector<bool> wasted_tests(const Steps& steps, const Outcomes& outcomes);
/// The same by the verdicts on the query's tests, see Attribution::wasted_by.
std::vector<bool> wasted_tests(const Attribution& verdicts);

/// For each triangle of A (`side` 0) or B (1), the number of tests of the query in which it took
/// part. `shape`: of the body's tree. `wasted`: wasted_tests, needed for HeatOf::wasted only.
std::vector<std::uint32_t> triangle_heat(const Steps& steps, const TreeShape& shape,
                                         std::size_t side, HeatOf of,
                                         const std::vector<bool>& wasted = {});

}  // namespace scb
