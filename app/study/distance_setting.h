#pragma once

#include <optional>

#include "core/analysis/tuning.h"
#include "scb/distance.h"
#include "scb/packed_layout.h"

namespace scb::app {

/// How queries of distances are made.
struct DistanceSetting {
    TuneSetting hierarchy;  ///< without its overlap test
    DistanceOrder order = DistanceOptions{}.order;
    std::optional<PackedLayout> layout{};  ///< none: the reference
    bool seeded = false;  ///< begins with the closest triangles of the frame before
};

}  // namespace scb::app
