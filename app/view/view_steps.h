#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "app/query/scene_query.h"

namespace scb::app {

/// What `scb explain` says of these tests, by their numbers; without the volumes.
nlohmann::ordered_json view_steps_json(const SceneQuery& query, const TraceFrame& frame,
                                       std::span<const std::uint32_t> tests);

}  // namespace scb::app
