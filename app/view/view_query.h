#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "app/view/view_columns.h"
#include "render/web/block_store.h"

namespace scb::app {

/// The queries of a column, with all their tests and what these are worth: see render/web/query.js.
/// Of the frames that are in the page. `steps`: so many tests have the steps of the overlap test
/// with them, those that cost the most. `step` is called after each frame.
nlohmann::ordered_json view_query_json(const ViewColumn& column, const std::vector<int>& frames,
                                       std::size_t steps, render::BlockStore& store,
                                       const std::function<void()>& step);

}  // namespace scb::app
