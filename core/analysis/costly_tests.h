#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/traversal_tree.h"

namespace scb {

/// `most` tests of a query, ascending: of `first`, in its order, then those from which the most
/// others followed, equal ones by their order.
std::vector<std::uint32_t> costly_tests(const TraversalTree& tree,
                                        std::span<const std::uint32_t> first, std::size_t most);

}  // namespace scb
