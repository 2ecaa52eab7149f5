#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/pictures/query_view.h"

namespace scb::app {

/// What index.json says of a run that draws queries: scene, bodies, what was asked, camera, ids.
nlohmann::ordered_json query_index_head(const QueryView& view, const std::string& command);

/// What it says of one picture: the counts of its query, or of both as `queries`; and, of a view of
/// the bodies, the camera, where it moves, and what numbers_by_id says where ids were asked for.
nlohmann::ordered_json query_index_entry(const QueryView& view, const QueryFrames& frames,
                                         const render::Camera& camera);
nlohmann::ordered_json query_index_entry(const QueryView& view, const QueryFrames& frames);

/// For each query, the ids of its pairs: {"first": ..., "count": ...}, see pair_id_ranges.
nlohmann::ordered_json pair_ids_json(const QueryView& view, const QueryFrames& frames);

}  // namespace scb::app
