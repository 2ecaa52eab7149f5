#pragma once

#include <optional>
#include <string>

#include "app/inspect/recording_settings.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// The report of `scb inspect` on a recording, as tables and sentences. Lists at most `top`
/// problems of a tree, at most `top` frames, and `cases` cases per reason. `settings`: the work of
/// this project's hierarchies, if it was counted.
std::string recording_text(const scenes::RecordingJudgement& judged,
                           const std::optional<RecordingSettings>& settings,
                           const std::string& file, std::size_t top, std::size_t cases);

}  // namespace scb::app
