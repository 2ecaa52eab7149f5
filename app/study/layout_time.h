#pragma once

#include <cstdint>

#include "scb/any_hierarchy.h"
#include "scb/collide.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// assumed_time of a query of packed hierarchies with leaves of four triangles; `volume` is scb or
/// scb2. Fitted to the same scenes on the same machine; queries took 0.8 to 1.3 of the assumed
/// time, where triangles touch each other up to 1.4.
std::uint64_t layout_time(VolumeKind volume, const PackedLayout& layout, const Collision& found);

}  // namespace scb::app
