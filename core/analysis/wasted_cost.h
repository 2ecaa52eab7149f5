#pragma once

#include <vector>

#include "core/hierarchy/tree_shape.h"
#include "scb/step.h"

namespace scb {

/// The cost of one test of two volumes and of one test of two triangles, in any unit.
struct TestCosts {
    double volumes = 1;
    double triangles = 1;
};

/// For each triangle of A (`side` 0) or B (1), its part in the cost of wasted tests, over the cost
/// of all tests of the query. Half of a test's cost belongs to each body; there the triangles below
/// the node share it alike. So the sum over all triangles of both bodies is the wasted share of the
/// cost. A test of triangles is wasted if they do not intersect. `shape`: of the body's tree;
/// `wasted`: wasted_tests. All 0 for a query without tests.
std::vector<double> wasted_cost(const Steps& steps, const TreeShape& shape, std::size_t side,
                                const std::vector<bool>& wasted, const TestCosts& costs);

}  // namespace scb
