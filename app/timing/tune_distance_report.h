#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/tune_distance.h"

namespace scb::app {

/// The calls of the library that build such a hierarchy of `mesh` and make a query.
std::string distance_code(const DistanceTuning& tuning, const DistanceSetting& setting);

/// A table for a reader, with sentences on the best.
std::string distance_tune_table(const DistanceTuning& tuning);

nlohmann::ordered_json distance_tune_json(const DistanceTuning& tuning);

}  // namespace scb::app
