#pragma once

#include "core/analysis/hierarchy_measures.h"
#include "core/model/tree.h"

namespace scb {

/// The measures of any builder's tree whose items are the triangles of `mesh`. Nodes without a
/// volume contain everything, and have no size.
HierarchyMeasures tree_measures(const Tree& tree, const Mesh& mesh, int threads = 1);

}  // namespace scb
