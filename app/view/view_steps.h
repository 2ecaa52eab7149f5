#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "app/study/scene_query.h"

namespace scb::app {

/// The explanation of these tests by `scb explain`, by test number; without the volumes.
nlohmann::ordered_json view_steps_json(const SceneQuery& query, const QueryTrace& frame,
                                       std::span<const std::uint32_t> tests);

}  // namespace scb::app
