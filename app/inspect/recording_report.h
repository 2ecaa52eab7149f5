#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// What `scb inspect` says of a recording, as tables and sentences; at most `top` problems of a
/// tree, and frames, are listed, and `cases` of what went wrong for each reason.
std::string recording_text(const scenes::RecordingJudgement& judged, const std::string& file,
                           std::size_t top, std::size_t cases);

/// The same, all of it.
nlohmann::ordered_json recording_json(const scenes::RecordingJudgement& judged,
                                      const std::string& file);

}  // namespace scb::app
