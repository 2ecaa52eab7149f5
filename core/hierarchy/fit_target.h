#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "core/hierarchy/fit_volumes.h"

namespace scb {

/// The place of fitted volumes: of all nodes down to a depth, or of the nodes that may be packed.
template <class V>
struct FitTarget {
    std::span<V> volumes = {};                      ///< per node
    int deepest = std::numeric_limits<int>::max();  ///< the depth
    PackableVolumes<V>* packable = nullptr;         ///< if set, instead of `volumes`
    std::uint32_t leaf_triangles = 1;               ///< of packed leaves
};

}  // namespace scb
