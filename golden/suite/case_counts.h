#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "golden/suite/suite.h"

namespace scb::golden {

/// The counts of what a run of a case made: of the index.json beside its pictures, or of the JSON
/// that it printed. A tree of objects with sorted keys whose leaves are integers: lists of frames,
/// bodies, depths and tests become objects by their names, `frames/100/stages/ball-slab`; a
/// `pairs_hash` becomes the number that its upper 53 bits are, which any reader of JSON keeps;
/// everything else (lengths, options, versions, ids of pixels) is left out. Throws InputError where
/// it is no such document, where two elements of a list have one name or one has none, and where
/// there are no counts.
nlohmann::json case_counts(GoldenRun run, const nlohmann::json& document);

/// The frame that such counts are of, where it is one; else empty.
std::string only_frame(const nlohmann::json& counts);

}  // namespace scb::golden
