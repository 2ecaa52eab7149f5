#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/query/level_trees.h"
#include "app/query/query_sources.h"
#include "render/web/block_store.h"

namespace scb::app {

/// The tests and pairs of a query's frames, for the page of `scb view`; `trees` are those of the
/// same kind that the page has. Adds to the store.
nlohmann::ordered_json view_query_json(QuerySource& source, const LevelTrees& trees,
                                       render::BlockStore& store);

}  // namespace scb::app
