#include "app/inspect/inspect_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/command_text.h"
#include "app/inspect/compared_recording.h"
#include "app/study/layout_time.h"
#include "app/timing/tune_layout_report.h"
#include "app/timing/tune_progress.h"
#include "app/timing/tune_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "render/figures/bench_figure.h"
#include "render/figures/figure_words.h"
#include "render/overlay/figure_layout.h"
#include "scb/error.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

/// Limit of the frames of a trace in a command.
constexpr std::size_t most_named_frames = 20;

/// The scene in a command; for a trace, the scene as recorded.
std::string scene_words(const InspectOptions& options, const QuerySource& source) {
    if (!scenes::names_trace(options.scene.names[0])) return options.of_scene;
    std::string words;
    for (const std::string& name : source.header().source) words += " " + file_word(name);
    if (source.frames().size() <= most_named_frames)
        words += " --frames " + list_text(source.frames());
    if (source.header().source.size() != 2) return words;
    std::string numbers;
    for (const double number : scenes::rows_of(source.query().b_to_a(source.frames()[0])))
        numbers += (numbers.empty() ? "" : ",") + format("%.17g", number);
    return words + " --pose=" + numbers;
}

/// The settings for queries of this project.
std::optional<InspectSettings> settings_of_scene(const InspectOptions& options,
                                                 const QuerySource& source,
                                                 const FrameFindings& findings,
                                                 const Console& console,
                                                 const InterruptWatch& watch) {
    const SceneQuery& query = source.query();
    const TraceHeader& header = source.header();
    TuneOptions asked;
    asked.base = {header.volume, header.split, header.options.overlap, header.options.descent,
                  header.growth};
    asked.build = query.build;
    asked.repeats = options.time ? 5 : 0;
    if (!query.is_self()) asked.layouts = options.time ? tried_layouts() : widest_layouts();
    asked.gives_up = !options.time;
    Work all;
    for (const InspectedFrame& frame : findings.frames) all += frame.found.counts.all;
    std::vector<int> counted;
    for (const std::size_t i : counted_frames(source.frames().size(), all))
        counted.push_back(source.frames()[i]);
    const TuneProgress progress = tune_progress(console, watch);
    std::optional<SceneTuning> tuning =
        tune_scene(query.scene, query.a, query.b, counted, asked, progress);
    if (!tuning) return std::nullopt;
    InspectSettings result;
    result.tuning = std::move(*tuning);
    result.cuts = try_cuts(query.scene, query.a, query.b, result.tuning, findings.tested, progress);
    result.clean = try_clean_meshes(query.scene, query.a, query.b, result.tuning, progress);
    result.scene = options.of_files;
    if (scenes::names_trace(options.scene.names[0])) {
        result.scene.clear();
        for (const std::string& name : header.source) result.scene += " " + file_word(name);
    }
    const SceneTuning& found = result.tuning;
    const std::string scene = scene_words(options, source);
    result.command =
        "scb collide" + scene + setting_options(found.rows[found.recommended()].setting);
    if (found.quicker_layout)
        result.layout_command =
            "scb collide" + scene + layout_options(found, found.layouts[*found.quicker_layout]);
    return result;
}

/// The settings for the meshes and poses of a recording.
std::optional<InspectSettings> settings_of_recording(const InspectOptions& options,
                                                     const QuerySource& source,
                                                     const FrameFindings& findings,
                                                     const Console& console,
                                                     const InterruptWatch& watch) {
    TuneOptions asked;
    asked.base.volume = VolumeKind::scb2;
    asked.base.growth = options.hierarchy.growth;
    asked.build = options.hierarchy.build();
    asked.layouts = widest_layouts();
    asked.gives_up = true;
    const TuneProgress progress = tune_progress(console, watch);
    const ComparedRecording compared = compared_recording(source, findings);
    const auto& [scene, a, b, frames, recorded, pairs] = compared;
    std::optional<SceneTuning> tuning = tune_scene(scene, a, b, frames, asked, progress);
    if (!tuning) return std::nullopt;
    InspectSettings result;
    result.tuning = std::move(*tuning);
    result.engine = render::volume_title(source.header());
    result.recorded = recorded;
    const auto inspected = layouts_of(options.layout.layout, options.layout.leaf_triangles).front();
    if (inspected && inspected->leaf_triangles == most_leaf_triangles)
        result.packed_cost = layout_time(options.hierarchy.kind(), *inspected,
                                         recorded.volume_tests, recorded.triangle_tests, pairs);
    result.cuts = try_cuts(scene, a, b, result.tuning, findings.tested, progress);
    result.clean = try_clean_meshes(scene, a, b, result.tuning, progress);
    result.scene = options.of_files;
    // The recording may have frames in which these bodies have no query.
    const std::string collide =
        "scb collide" + options.of_meshes + " --frames " + list_text(frames);
    const SceneTuning& found = result.tuning;
    result.command = collide + setting_options(found.rows[found.recommended()].setting);
    if (found.quicker_layout)
        result.layout_command =
            collide + layout_options(found, found.layouts[*found.quicker_layout]);
    return result;
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

/// Says how many settings have no row.
std::string given_up_text(const SceneTuning& tuning) {
    if (tuning.given_up == 0) return "";
    return format(
        "%zu of %zu settings were given up: they cost over %d times the least before them.\n",
        tuning.given_up, tuning.given_up + tuning.rows.size(), static_cast<int>(hopeless_cost));
}

std::string recorded_text(const InspectSettings& settings) {
    const SceneTuning& tuning = settings.tuning;
    std::string text =
        "\nWhat would have helped: the same queries by this project's hierarchies, " +
        render::frames_text(tuning.frames) + "\n";
    std::size_t width = character_count(settings.engine);
    const std::vector<std::size_t> rows = listed_settings(settings);
    std::uint64_t least = tuning.rows[rows.front()].counts.picoseconds;
    std::string packed;
    const TuneLayout* const layout = tuning.cheapest_layout();
    if (layout) {
        packed = layout_text(tuning, *layout) + ", packed";
        least = layout->picoseconds;
    }
    const auto cost_text = [least](std::uint64_t cost) {
        return format("  %6.2f\n", ratio(static_cast<double>(cost), static_cast<double>(least)));
    };
    width = std::max(width, character_count(packed));
    for (const std::size_t row : rows)
        width = std::max(width, character_count(setting_text(tuning.rows[row].setting)));
    text += "  " + left_aligned("by cost", width) +
            "         N_v  /rec'd         N_p  /rec'd    cost\n  " +
            left_aligned(settings.engine, width) +
            counts_text(*settings.recorded, *settings.recorded) + "\n";
    if (layout)
        text += "  " + left_aligned(packed, width) +
                counts_text({layout->n_v, layout->n_p}, *settings.recorded) + cost_text(least);
    for (const std::size_t row : rows)
        text += "  " + left_aligned(setting_text(tuning.rows[row].setting), width) +
                counts_text(tuning.rows[row].counts, *settings.recorded) +
                cost_text(tuning.rows[row].counts.picoseconds);
    return text + "cost, relative to the lowest cost: " + cost_words + "\n" +
           given_up_text(tuning) + use_text(tuning, settings.command, settings.layout_command);
}

}  // namespace

std::optional<InspectSettings> inspect_settings(const InspectOptions& options,
                                                const QuerySource& source,
                                                const FrameFindings& findings,
                                                const Console& console,
                                                const InterruptWatch& watch) {
    return source.is_recording() ? settings_of_recording(options, source, findings, console, watch)
                                 : settings_of_scene(options, source, findings, console, watch);
}

std::vector<std::size_t> listed_settings(const InspectSettings& settings) {
    const SceneTuning& tuning = settings.tuning;
    if (!settings.recorded) return tuning.listed(most_settings);
    std::vector<std::size_t> rows;
    std::set<VolumeKind> seen;
    for (const std::size_t row : tuning.best)
        if (seen.insert(tuning.rows[row].setting.volume).second) rows.push_back(row);
    return rows;
}

std::string settings_words(const SceneTuning& tuning, std::size_t frames, const std::string& over) {
    const std::size_t counted = tuning.frames.size();
    if (frames == 1) return "frame " + std::to_string(tuning.frames[0]);
    return over + " " +
           (counted == frames ? std::to_string(frames)
                              : std::to_string(counted) + " of the " + std::to_string(frames)) +
           " frames";
}

std::string settings_text(const InspectSettings& settings, std::size_t frames) {
    if (settings.recorded) return recorded_text(settings);
    const SceneTuning& tuning = settings.tuning;
    return "\nwhat would have helped, by cost, the least first: " +
           settings_words(tuning, frames, "means per frame over") + "\ncost: " + cost_words +
           ", relative to the cost of the base, which is the present setting\n" +
           tune_rows_text(tuning, most_settings, "the present setting") + given_up_text(tuning) +
           "\n" + use_text(tuning, settings.command, settings.layout_command);
}

nlohmann::ordered_json settings_json(const InspectSettings& settings) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    if (!settings.recorded) {
        const nlohmann::ordered_json tuning = tune_json(settings.tuning);
        for (const char* key :
             {"frames", "timed_frames", "settings", "best_first", "best", "layouts"})
            if (tuning.contains(key)) json[key] = tuning[key];
        json["given_up"] = settings.tuning.given_up;
        json["command"] = settings.command;
        if (!settings.layout_command.empty()) json["layout_command"] = settings.layout_command;
        return json;
    }
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const std::size_t row : listed_settings(settings)) {
        const TuneRow& of = settings.tuning.rows[row];
        rows.push_back({{"volume", volume_kind_name(of.setting.volume)},
                        {"setting", setting_text(of.setting)},
                        {"n_v", of.counts.volume_tests},
                        {"n_p", of.counts.triangle_tests}});
    }
    return {
        {"frames", settings.tuning.frames},
        {"recorded",
         {{"n_v", settings.recorded->volume_tests}, {"n_p", settings.recorded->triangle_tests}}},
        {"settings", std::move(rows)},
        {"given_up", settings.tuning.given_up},
        {"command", settings.command}};
}

}  // namespace scb::app
