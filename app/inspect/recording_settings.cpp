#include "app/inspect/recording_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/command_text.h"
#include "app/timing/tune_progress.h"
#include "app/timing/tune_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/figures/bench_figure.h"
#include "render/figures/volume_titles.h"
#include "render/overlay/figure_layout.h"
#include "scb/error.h"
#include "scenes/recordings/recorded_trace.h"

namespace scb::app {
namespace {

/// The row with the least cost of each volume, in ascending order of cost.
std::vector<std::size_t> rows_best_by_volume(const SceneTuning& tuning) {
    std::vector<std::size_t> rows;
    std::set<VolumeKind> seen;
    for (const std::size_t row : tuning.best)
        if (seen.insert(tuning.rows[row].setting.volume).second) rows.push_back(row);
    return rows;
}

std::string counts_text(const Work& counts, const Work& of) {
    return right_aligned(render::count_text(counts.volume_tests), 12) +
           format("  %6.2f", ratio(static_cast<double>(counts.volume_tests),
                                   static_cast<double>(of.volume_tests))) +
           right_aligned(render::count_text(counts.triangle_tests), 12) +
           (of.triangle_tests == 0
                ? std::string(8, ' ')
                : format("  %6.2f", ratio(static_cast<double>(counts.triangle_tests),
                                          static_cast<double>(of.triangle_tests))));
}

}  // namespace

std::optional<RecordingSettings> recording_settings(
    std::shared_ptr<const scenes::Recording> of_file, const std::string& bodies,
    const std::string& frames, const Console& console, const InterruptWatch& watch) {
    const scenes::Recording& recording = *of_file;
    const std::string& path = recording.file->path;
    scenes::RecordedTrace recorded(std::move(of_file), bodies, frames);
    const TraceHeader& header = recorded.header();
    if (header.engine->objects)
        throw InputError(path + ": its items are objects without triangles.");
    if (recorded.sides()[0] == recorded.sides()[1])
        throw InputError(path + ": its queries are of a body against itself.");
    if (!recording.refusal.empty() && !recording.changes_meshes)
        throw InputError(recording.refusal);
    Work all;
    std::vector<Work> of_frames;
    for (const int frame : recorded.frames()) {
        const Collision& found = recorded.frame(frame).found;
        of_frames.push_back({found.n_v, found.n_p, 0});
        all += of_frames.back();
    }
    if (all.volume_tests == 0) throw InputError(path + ": no tests of volumes were recorded.");
    RecordingSettings result;
    result.engine = render::volume_title(header);
    std::vector<int> chosen;
    std::vector<std::size_t> places = counted_frames(recorded.frames().size(), all);
    // Hierarchies of this project have one mesh, so only one frame can be used.
    if (recording.changes_meshes)
        places = {static_cast<std::size_t>(std::max_element(of_frames.begin(), of_frames.end()) -
                                           of_frames.begin())};
    for (const std::size_t i : places) {
        chosen.push_back(recorded.frames()[i]);
        result.recorded += of_frames[i];
    }
    TuneOptions asked;
    asked.base.volume = VolumeKind::scb2;
    asked.layouts = false;
    std::optional<SceneTuning> tuning = tune_scene(
        recording.changes_meshes ? scenes::scene_at(recording, chosen[0]) : recorded.scene(),
        recorded.sides()[0], recorded.sides()[1], chosen, asked, tune_progress(console, watch));
    if (!tuning) return std::nullopt;
    result.tuning = std::move(*tuning);
    result.command = "scb collide " + file_word(path) +
                     (recording.changes_meshes ? " --frames " + std::to_string(chosen[0]) : "") +
                     (bodies.empty() ? "" : " --bodies " + file_word(bodies)) +
                     setting_options(result.tuning.rows[result.tuning.recommended()].setting);
    return result;
}

std::string recording_settings_text(const RecordingSettings& settings) {
    const SceneTuning& tuning = settings.tuning;
    std::string text =
        "\nWhat would have helped: the same queries by this project's hierarchies, " +
        render::frames_text(tuning.frames) + "\n";
    std::size_t width = character_count(settings.engine);
    const std::vector<std::size_t> rows = rows_best_by_volume(tuning);
    const auto cost_of = [&tuning](std::size_t row) {
        return static_cast<double>(estimated_cost(tuning.rows[row].counts));
    };
    for (const std::size_t row : rows)
        width = std::max(width, character_count(setting_text(tuning.rows[row].setting)));
    text += "  " + left_aligned("by cost", width) +
            "         N_v  /rec'd         N_p  /rec'd    cost\n  " +
            left_aligned(settings.engine, width) +
            counts_text(settings.recorded, settings.recorded) + "\n";
    for (const std::size_t row : rows)
        text += "  " + left_aligned(setting_text(tuning.rows[row].setting), width) +
                counts_text(tuning.rows[row].counts, settings.recorded) +
                format("  %6.2f\n", cost_of(row) / cost_of(rows.front()));
    return text + "cost, of the least: " + cost_words + "\n  " + settings.command + "\n";
}

nlohmann::ordered_json recording_settings_json(const RecordingSettings& settings) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const std::size_t row : rows_best_by_volume(settings.tuning)) {
        const TuneRow& of = settings.tuning.rows[row];
        rows.push_back({{"volume", volume_kind_name(of.setting.volume)},
                        {"setting", setting_text(of.setting)},
                        {"n_v", of.counts.volume_tests},
                        {"n_p", of.counts.triangle_tests}});
    }
    return {{"frames", settings.tuning.frames},
            {"recorded",
             {{"n_v", settings.recorded.volume_tests}, {"n_p", settings.recorded.triangle_tests}}},
            {"settings", std::move(rows)},
            {"command", settings.command}};
}

}  // namespace scb::app
