#pragma once

#include <cstdint>

#include "scb/any_hierarchy.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// assumed_time of a query of packed hierarchies with leaves of four triangles, by its counts and
/// the number of pairs that it finds; `volume` is scb or scb2. Fitted to 13 of its scenes on the
/// same machine. Queries take 0.7 to 1.5 of the assumed time, and up to 2.2 of it where parts lie
/// on each other.
std::uint64_t layout_time(VolumeKind volume, const PackedLayout& layout, std::uint64_t n_v,
                          std::uint64_t n_p, std::uint64_t pairs);

}  // namespace scb::app
