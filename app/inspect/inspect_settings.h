#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/inspect/inspect_options.h"
#include "app/study/cure_trial.h"
#include "app/study/cut_trial.h"
#include "app/study/frame_findings.h"
#include "app/study/query_source.h"
#include "app/study/tune_run.h"

namespace scb::app {

/// The settings of this project's hierarchies that would have helped in the inspected queries.
struct InspectSettings {
    SceneTuning tuning;          ///< the base is the present setting; scb2 for a recording
    std::string command;         ///< makes the queries with the recommended setting
    std::string layout_command;  ///< the same with a packed layout, if that is quicker
    /// Of a recording: the engine and its volumes, and its work in the frames of `tuning`.
    std::string engine;
    std::optional<Work> recorded;
    /// The assumed time of that work if it is of packed hierarchies with leaves of four triangles.
    std::optional<std::uint64_t> packed_cost;
    std::optional<CutTrial> cuts;    ///< of the triangles in most tests
    std::optional<CureTrial> clean;  ///< of copies and degenerate triangles
    std::string scene;               ///< its meshes in a command
};

/// Limit of the settings listed besides the setting of the queries.
inline constexpr std::size_t most_settings = 8;

/// Tries the settings on the meshes and poses of the queries, in the inspected frames, or in evenly
/// spread ones if all would take more than seconds; if the meshes of a recording change, in the
/// frame with the most volume tests. None if interrupted. Throws InputError if a recording cannot
/// be compared: objects without meshes, poses that are not rigid, a body against itself, or no
/// volume tests. `findings`: of all inspected frames.
std::optional<InspectSettings> inspect_settings(const InspectOptions& options,
                                                const QuerySource& source,
                                                const FrameFindings& findings,
                                                const Console& console,
                                                const InterruptWatch& watch);

/// The rows of the table for a reader: of a recording, the best setting of each volume; else the
/// best settings. The best first.
std::vector<std::size_t> listed_settings(const InspectSettings& settings);

/// A table, with the command of the recommended setting. `frames`: the number of inspected frames.
std::string settings_text(const InspectSettings& settings, std::size_t frames);
nlohmann::ordered_json settings_json(const InspectSettings& settings);

/// The frames in which the settings were counted: "frame 150", or `over` and "10 of the 50 frames".
std::string settings_words(const SceneTuning& tuning, std::size_t frames, const std::string& over);

}  // namespace scb::app
