#pragma once

#include <nlohmann/json.hpp>

#include "golden/suite.h"

namespace scb {

/// The counts of what a run of a case made: of the index.json beside its pictures, or of the JSON
/// that it printed. A tree of objects with sorted keys whose leaves are integers: lists of frames,
/// bodies, depths and tests become objects by their names, `frames/100/stages/ball-slab`;
/// everything else (lengths, options, versions, ids of pixels) is left out.
nlohmann::json case_counts(GoldenRun run, const nlohmann::json& document);

}  // namespace scb
