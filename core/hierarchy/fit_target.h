#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "core/hierarchy/fit_volumes.h"

namespace scb {

/// The place of fitted volumes: of all nodes down to a depth, or of some nodes.
template <class V>
struct FitTarget {
    std::span<V> volumes = {};
    int deepest = std::numeric_limits<int>::max();  ///< the depth
    /// Of each node's volume in `volumes`, or no_place. Empty: the index of the node.
    std::span<const std::uint32_t> place = {};
};

}  // namespace scb
