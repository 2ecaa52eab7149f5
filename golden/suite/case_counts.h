#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "golden/suite/suite.h"

namespace scb::golden {

/// The counts of a run of a case: from the index.json beside its pictures, or from the JSON that it
/// printed. A tree of objects with sorted keys whose leaves are integers: lists of frames, bodies,
/// depths and tests become objects by their names, `frames/100/stages/ball-slab`; a `pairs_hash`
/// becomes the number of its upper 53 bits, which any reader of JSON keeps; everything else
/// (lengths, options, versions, ids of pixels) is left out. A query of `scb distance` also has its
/// distance, `distance/value` and `distance/bound`, see counts_difference, and, unless it is 0, its
/// triangles; `inside` is the number of parts inside the other body. Throws InputError if it is not
/// such a document, if two elements of a list have one name or one has none, and if there are no
/// counts.
nlohmann::json case_counts(GoldenRun run, const nlohmann::json& document);

/// The frame of such counts, if it is only one; else empty.
std::string only_frame(const nlohmann::json& counts);

}  // namespace scb::golden
