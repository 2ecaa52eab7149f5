#include "app/inspect/distance_advice.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/inspect/compared_recording.h"
#include "app/query/distance_options.h"
#include "app/study/distance_setting_text.h"
#include "app/timing/tune_progress.h"
#include "core/analysis/pass_counts.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "render/figures/figure_words.h"
#include "render/figures/inspect_figure.h"
#include "render/overlay/figure_layout.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Of the present setting; of the best one if the queries were recorded.
double cost_share(const DistanceRow& row, const DistanceAdvice& advice) {
    const DistanceTrial& trial = advice.trial;
    const DistanceRow& base = advice.recorded ? trial.best() : trial.rows[0];
    return ratio(static_cast<double>(row.work.picoseconds),
                 static_cast<double>(base.work.picoseconds));
}

/// The queries of a recording, with the default hierarchies of `scb distance`.
SceneQuery query_of(ComparedRecording compared, const TraceHeader& header,
                    HierarchyOptions hierarchy) {
    QueryOptions ignored;
    set_distance_defaults(hierarchy, ignored);
    SceneQuery query;
    query.scene = std::move(compared.scene);
    query.frames = compared.frames;
    query.a = compared.a;
    query.b = compared.b;
    query.kind = hierarchy.kind();
    query.build = hierarchy.build();
    query.topologies = scenes::build_topologies(query.scene, query.build.topology());
    query.hierarchies = scenes::fit_meshes(query.topologies, query.kind, query.build);
    query.distance = {header.distance, std::nullopt};
    if (header.kind == QueryKind::within) query.distance->within = header.tolerance;
    return query;
}

/// The limits of recorded queries in a command.
std::string limit_options(const TraceHeader& header) {
    if (header.kind == QueryKind::within) return " --within " + exact_number(header.tolerance);
    std::string text;
    if (std::isfinite(header.distance.limit))
        text += " --limit " + exact_number(header.distance.limit);
    if (header.distance.relative_error > 0)
        text += " --relative-error " + exact_number(header.distance.relative_error);
    return text;
}

/// The arguments of the commands of an advice.
struct CommandParts {
    std::string scene, limits;
};

/// The rules that all settings of a trial share, if they are not the default.
std::string given_build(const TuneSetting& setting) {
    const TuneSetting usual;
    std::string text;
    if (setting.growth != usual.growth)
        text += " --growth " + std::string(ball_growth_name(setting.growth));
    if (setting.descent != usual.descent)
        text += " --descent " + std::string(descent_rule_name(setting.descent));
    return text;
}

/// The commands for the best setting.
void add_commands(DistanceAdvice& advice, const CommandParts& parts) {
    const DistanceSetting &best = advice.trial.best().setting,
                          &present = advice.trial.rows[0].setting;
    advice.command = "scb distance" + parts.scene + parts.limits + distance_options(best);
    const auto both = [](std::string_view of_present, std::string_view of_best) {
        std::string text(of_present);
        if (of_best != of_present) text += "," + std::string(of_best);
        return text;
    };
    advice.timing =
        "scb bench" + parts.scene + " --kind distance" + parts.limits + " --volume " +
        both(volume_kind_name(present.hierarchy.volume), volume_kind_name(best.hierarchy.volume)) +
        " --split " +
        both(split_method_name(present.hierarchy.split), split_method_name(best.hierarchy.split)) +
        given_build(present.hierarchy) +
        (advice.trial.is_within ? "" : " --order " + std::string(distance_order_name(best.order))) +
        (best.layout ? " --layout reference," + packed_layout_name(*best.layout) : "");
}

}  // namespace

std::optional<DistanceAdvice> distance_advice(const InspectOptions& options,
                                              const QuerySource& source,
                                              const FrameFindings& findings, const Console& console,
                                              const InterruptWatch& watch) {
    DistanceAdvice advice;
    CommandParts parts;
    std::vector<int> frames;
    std::optional<DistanceTrial> trial;
    const TuneProgress progress = tune_progress(console, watch);
    if (source.is_recording()) {
        const scenes::RecordedTrace& recorded = *source.recorded();
        if (!recorded.has_same_limits())
            throw InputError(
                recorded.recording().file->path +
                ": its queries have several limits or relative errors; select queries that "
                "have the same with --frames, --query or --tag.");
        ComparedRecording compared = compared_recording(source, findings);
        frames = compared.frames;
        advice.engine = render::volume_title(source.header());
        advice.recorded = compared.recorded;
        advice.changes_meshes = recorded.recording().changes_meshes;
        parts = {options.of_meshes + " --frames " + list_text(frames),
                 limit_options(source.header())};
        trial = try_distances(query_of(std::move(compared), source.header(), options.hierarchy),
                              frames, progress);
    } else {
        Work all;
        for (const InspectedFrame& frame : findings.frames) all += frame.found.counts.all;
        for (const std::size_t i : counted_frames(source.frames().size(), all))
            frames.push_back(source.frames()[i]);
        const bool are_all = frames.size() == source.frames().size();
        parts = {
            options.of_bodies + (are_all ? options.of_frames : " --frames " + list_text(frames)),
            options.of_distances};
        trial = try_distances(source.query(), frames, progress);
    }
    if (!trial) return std::nullopt;
    advice.trial = std::move(*trial);
    add_commands(advice, parts);
    return advice;
}

std::string advice_sentence(const DistanceAdvice& advice) {
    const DistanceTrial& trial = advice.trial;
    const DistanceRow &best = trial.best(), &present = trial.rows[0];
    const std::size_t counted = trial.frames.size();
    const std::string where = counted == 1 ? " in frame " + std::to_string(trial.frames[0])
                                           : " over " + std::to_string(counted) + " frames";
    const std::string setting = setting_words(best.setting, trial.is_within);
    const auto counts = [&best](const Work& base) {
        return "N_v " + render::count_text(best.work.volume_tests) + " in place of " +
               render::count_text(base.volume_tests) + ", N_p " +
               render::count_text(best.work.triangle_tests) +
               (best.setting.layout ? " in doubles" : "") + " in place of " +
               render::count_text(base.triangle_tests);
    };
    if (advice.recorded)
        return "This project's best of " + std::to_string(trial.tried) + " settings" + where +
               ": " + setting + ". Compared with " + advice.engine + ": " +
               counts(*advice.recorded) + ". Tests of two engines may take different times." +
               (advice.changes_meshes ? " The meshes change, so one frame is compared." : "");
    if (&best == &present)
        return "None of " + std::to_string(trial.tried) + " settings costs less" + where +
               " than the present setting.";
    return "Best of " + std::to_string(trial.tried) + " settings" + where + ": " + setting +
           format(", with %.3f of the cost of the present setting: ", cost_share(best, advice)) +
           counts(present.work) + ". Cost: assumed time of the tests.";
}

std::string trial_words(const DistanceAdvice& advice) {
    const char* const base = advice.recorded ? "best" : "present";
    return std::string("The same queries with ") +
           (advice.recorded ? "this project's hierarchies" : "other settings") +
           ". Each row has the sums over the frames. The setting of the least cost comes first. "
           "The "
           "cost is the assumed time of the tests, divided by the cost of the " +
           base + " setting. N_p of packed layouts counts the pairs that were measured in doubles.";
}

Table trial_table(const DistanceAdvice& advice, std::size_t most) {
    const DistanceTrial& trial = advice.trial;
    const Work& base = advice.recorded ? *advice.recorded : trial.rows[0].work;
    const auto name = [&](const DistanceRow& row) {
        return setting_words(row.setting, trial.is_within) +
               (!advice.recorded && &row == trial.rows.data() ? " (present)" : "");
    };
    // The default setting of a recording's comparison has the place that its cost gives it.
    std::vector<const DistanceRow*> rows;
    for (const DistanceRow& row : trial.rows) rows.push_back(&row);
    if (advice.recorded)
        std::stable_sort(rows.begin(), rows.end(), [](const DistanceRow* x, const DistanceRow* y) {
            return x->work.picoseconds < y->work.picoseconds;
        });
    rows.resize(std::min(rows.size(), most + (advice.recorded ? 0 : 1)));
    std::size_t width = std::max<std::size_t>(7, character_count(advice.engine));
    for (const DistanceRow* row : rows) width = std::max(width, name(*row).size());
    Table table({{.title = "setting", .key = "setting", .width = width, .align = Align::left},
                 {.title = "N_v", .key = "n_v", .width = 11, .before = 2},
                 {.title = advice.recorded ? "/engine" : "/present", .width = 8, .before = 2},
                 {.title = "N_p", .key = "n_p", .width = 9, .before = 2},
                 {.title = "cost", .key = "cost", .width = 7, .before = 2}});
    const auto add = [&](const std::string& title, const Work& work, const Cell& cost) {
        table.add({title,
                   {work.volume_tests, render::count_text(work.volume_tests)},
                   Cell(ratio(static_cast<double>(work.volume_tests),
                              static_cast<double>(base.volume_tests)),
                        "%.3f"),
                   {work.triangle_tests, render::count_text(work.triangle_tests)},
                   cost});
    };
    if (advice.recorded) add(advice.engine, base, "");
    for (const DistanceRow* row : rows)
        add(name(*row), row->work, Cell(cost_share(*row, advice), "%.3f"));
    return table;
}

Json advice_json(const DistanceAdvice& advice) {
    const DistanceTrial& trial = advice.trial;
    Json rows = Json::array();
    for (const DistanceRow& row : trial.rows) {
        const DistanceSetting& setting = row.setting;
        Json one = {{"volume", volume_kind_name(setting.hierarchy.volume)},
                    {"split", split_method_name(setting.hierarchy.split)}};
        if (!trial.is_within) {
            one["order"] = distance_order_name(setting.order);
            one["seeded"] = setting.seeded;
        }
        if (setting.layout) one["layout"] = packed_layout_name(*setting.layout);
        one["n_v"] = row.work.volume_tests;
        one["n_p"] = row.work.triangle_tests;
        one["cost"] = static_cast<double>(row.work.picoseconds) / 1000;
        rows.push_back(std::move(one));
    }
    Json json = {{"frames", trial.frames},
                 {"settings", std::move(rows)},
                 {"best", &trial.best() - trial.rows.data()},
                 {"given_up", trial.tried - trial.rows.size()},
                 {"command", advice.command},
                 {"timing", advice.timing}};
    if (advice.recorded)
        json["recorded"] = {{"n_v", advice.recorded->volume_tests},
                            {"n_p", advice.recorded->triangle_tests}};
    return json;
}

}  // namespace scb::app
