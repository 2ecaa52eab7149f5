#pragma once

#include <optional>
#include <string>

#include "app/inspect/recording_settings.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// What `scb inspect` says of a recording, as tables and sentences; at most `top` problems of a
/// tree, and frames, are listed, and `cases` of what went wrong for each reason. `settings`: what
/// own hierarchies take, where that was counted.
std::string recording_text(const scenes::RecordingJudgement& judged,
                           const std::optional<RecordingSettings>& settings,
                           const std::string& file, std::size_t top, std::size_t cases);

}  // namespace scb::app
