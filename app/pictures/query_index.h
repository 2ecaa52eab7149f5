#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/pictures/query_view.h"

namespace scb::app {

/// The description of a run that draws queries in index.json: scene, bodies, parameters, camera,
/// ids.
nlohmann::ordered_json query_index_head(const QueryView& view, const std::string& command);

/// The entry of one picture: the counts of its query, or of both as `queries`. For a view of the
/// bodies also the camera, if it moves, and numbers_by_id, if ids were asked for.
nlohmann::ordered_json query_index_entry(const QueryView& view, const QueryFrames& frames,
                                         const render::Camera& camera);
nlohmann::ordered_json query_index_entry(const QueryView& view, const QueryFrames& frames);

/// For each query, the ids of its pairs: {"first": ..., "count": ...}, see pair_id_ranges.
nlohmann::ordered_json pair_ids_json(const QueryView& view, const QueryFrames& frames);

}  // namespace scb::app
