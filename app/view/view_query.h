#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "app/view/view_columns.h"
#include "render/web/block_store.h"

namespace scb::app {

/// The queries of a column at the frames of the page, with all their tests and verdicts: see
/// render/web/query.js. `steps`: number of tests, the most costly ones, with the steps of their
/// overlap test. `step` is called after each frame.
nlohmann::ordered_json view_query_json(const ViewColumn& column, const std::vector<int>& frames,
                                       std::size_t steps, render::BlockStore& store,
                                       const std::function<void()>& step);

}  // namespace scb::app
