#pragma once

#include <vector>

#include "scb/event_recorder.h"
#include "scb/topology.h"

namespace scb {

/// Which tests of a query count for a triangle.
enum class HeatOf {
    volumes,    ///< of two volumes, where the one of its own body holds the triangle
    triangles,  ///< of two triangles
};

/// For each triangle of A (`side` 0) or B (1), in how many tests of the query it took part.
/// `topology` is that body's.
std::vector<std::uint32_t> triangle_heat(const Events& events, const Topology& topology,
                                         std::size_t side, HeatOf of);

}  // namespace scb
