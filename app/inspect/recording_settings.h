#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/timing/tune_run.h"
#include "scenes/recordings/recording.h"

namespace scb::app {

/// What this project's hierarchies make of the queries that were recorded.
struct RecordingSettings {
    std::string engine;  ///< with its volumes
    Work recorded;       ///< in the frames of `tuning`: volume and triangle tests
    SceneTuning tuning;
    std::string command;  ///< that makes the queries with the setting to use
};

/// Tries the settings on the recorded meshes and poses, in all of these frames, or evenly spread so
/// many as take seconds. Nothing where it was ended. Throws InputError where there is nothing to be
/// compared: objects without meshes, meshes that change, a body against itself, several pairs of
/// bodies of which `bodies` names none, or no tests of volumes.
std::optional<RecordingSettings> recording_settings(
    std::shared_ptr<const scenes::Recording> recording, const std::string& bodies,
    const std::string& frames, const Console& console, const InterruptWatch& watch);

/// As a table: the recorded counts, and the best setting of each volume.
std::string recording_settings_text(const RecordingSettings& settings);
nlohmann::ordered_json recording_settings_json(const RecordingSettings& settings);

}  // namespace scb::app
