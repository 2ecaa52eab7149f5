#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scb/step.h"

namespace scb {

/// For each step of a query, the number of steps in the part of the query that begins with it,
/// itself included: the cost of the pair. The cost of a divided pair is one more than the costs of
/// its children together. O(n).
std::vector<std::uint32_t> subtree_sizes(const Steps& steps);

/// At most `most` steps of a query, ascending: the steps of `first`, in its order, then the steps
/// with the most steps below them, equal ones in order.
std::vector<std::uint32_t> costly_tests(const Steps& steps, std::span<const std::uint32_t> first,
                                        std::size_t most);

}  // namespace scb
