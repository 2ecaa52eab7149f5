#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/mesh_facts.h"
#include "core/hierarchy/tree_shape.h"
#include "scb/step.h"

namespace scb {

/// A triangle of a body, and the tests of queries in which it takes part.
struct TestedTriangle {
    std::uint32_t triangle = 0;
    std::uint64_t items = 0;    ///< tests of the triangle
    std::uint64_t volumes = 0;  ///< tests of nodes that hold the triangle
};

/// The triangles of A (`side` 0) or B (1) that were tested with another triangle, ascending.
/// `shape`: of the body's tree.
std::vector<TestedTriangle> tested_triangles(const Steps& steps, const TreeShape& shape,
                                             std::size_t side);

/// Adds the tests of other queries of the same body. Both lists are ascending.
void add_tests(std::vector<TestedTriangle>& sum, const std::vector<TestedTriangle>& more);

/// A triangle that takes part in many tests, with the size that may be the cause.
struct CostlyTriangle {
    TestedTriangle tests;
    TriangleSize size;
};

/// At most `most` triangles, those with the most tests of triangles first; of these the ones with
/// the most tests of nodes, then the lowest numbers.
std::vector<CostlyTriangle> costly_triangles(std::vector<TestedTriangle> tested, const Mesh& mesh,
                                             std::size_t most);

/// The number of triangle tests in which triangles of the list take part. A self query counts a
/// test twice, once for each of its triangles.
std::uint64_t item_tests(const std::vector<TestedTriangle>& tested);

}  // namespace scb
