#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "app/query/scene_query.h"

namespace scb::app {

/// The tests of a frame that a page explains step by step, `most` of them: of `first`, then those
/// from which the most others followed. Ascending.
std::vector<std::uint32_t> explained_tests(const TraversalTree& tree,
                                           std::span<const std::uint32_t> first, std::size_t most);

/// What `scb explain` says of these tests, by their numbers; without the volumes.
nlohmann::ordered_json view_steps_json(const SceneQuery& query, const TraceFrame& frame,
                                       std::span<const std::uint32_t> tests);

}  // namespace scb::app
