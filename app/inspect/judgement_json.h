#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// All findings of `scb inspect` on a recording. `file`: the recording's name.
nlohmann::ordered_json recording_json(const scenes::RecordingJudgement& judged,
                                      const std::string& file);

}  // namespace scb::app
