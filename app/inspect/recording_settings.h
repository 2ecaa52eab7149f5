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

/// The work of this project's hierarchies in the recorded queries.
struct RecordingSettings {
    std::string engine;  ///< the engine and its volumes
    Work recorded;       ///< volume and triangle tests in the frames of `tuning`
    SceneTuning tuning;
    std::string command;  ///< makes the queries with the recommended setting
};

/// Tries the settings on the recorded meshes and poses, in these frames, or in evenly spread ones
/// if all would take more than seconds; if meshes change, in the frame with the most volume tests.
/// None if interrupted. Throws InputError if there is nothing to compare: objects without meshes,
/// poses that are not rigid, a body against itself, several pairs of bodies if `bodies` names none,
/// or no volume tests.
std::optional<RecordingSettings> recording_settings(
    std::shared_ptr<const scenes::Recording> recording, const std::string& bodies,
    const std::string& frames, const Console& console, const InterruptWatch& watch);

/// A table: the recorded counts, and the best setting of each volume.
std::string recording_settings_text(const RecordingSettings& settings);
nlohmann::ordered_json recording_settings_json(const RecordingSettings& settings);

}  // namespace scb::app
