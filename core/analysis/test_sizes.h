#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/traversal_tree.h"

namespace scb {

/// For each volume test, how many volume tests there are in the part of the tree that begins with
/// it, itself among them: what the pair cost. That of the roots is N_v; that of a pair which was
/// divided is one more than those of its children together. O(n).
std::vector<std::uint32_t> test_sizes(const TestTree& tree);

}  // namespace scb
