#include "app/inspect/distance_advice.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/command_text.h"
#include "app/study/distance_setting_text.h"
#include "app/timing/tune_progress.h"
#include "core/analysis/pass_counts.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "render/figures/inspect_figure.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

double cost_share(const DistanceRow& row, const DistanceTrial& trial) {
    return ratio(static_cast<double>(row.work.picoseconds),
                 static_cast<double>(trial.rows[0].work.picoseconds));
}

}  // namespace

std::optional<DistanceAdvice> distance_advice(const InspectOptions& options,
                                              const QuerySource& source,
                                              const FrameFindings& findings, const Console& console,
                                              const InterruptWatch& watch) {
    Work all;
    for (const InspectedFrame& frame : findings.frames) all += frame.found.counts.all;
    const std::vector<int>& inspected = source.frames();
    std::vector<int> frames;
    for (const std::size_t i : counted_frames(inspected.size(), all))
        frames.push_back(inspected[i]);
    const TuneProgress progress = tune_progress(console, watch);
    std::optional<DistanceTrial> trial = try_distances(source.query(), frames, progress);
    if (!trial) return std::nullopt;
    DistanceAdvice advice;
    advice.trial = std::move(*trial);
    std::string numbers;
    for (const int frame : frames)
        numbers += (numbers.empty() ? " --frames " : ",") + std::to_string(frame);
    const std::string scene =
        options.of_bodies + (frames.size() == inspected.size() ? options.of_frames : numbers);
    const DistanceSetting &best = advice.trial.best().setting,
                          &present = advice.trial.rows[0].setting;
    advice.command = "scb distance" + scene + options.of_distances + distance_options(best);
    const auto both = [](std::string_view of_present, std::string_view of_best) {
        std::string text(of_present);
        if (of_best != of_present) text += "," + std::string(of_best);
        return text;
    };
    advice.timing =
        "scb bench" + scene + " --kind distance" + options.of_distances + " --volume " +
        both(volume_kind_name(present.hierarchy.volume), volume_kind_name(best.hierarchy.volume)) +
        " --split " +
        both(split_method_name(present.hierarchy.split), split_method_name(best.hierarchy.split)) +
        (advice.trial.is_within ? "" : " --order " + std::string(distance_order_name(best.order))) +
        (best.layout ? " --layout reference," + packed_layout_name(*best.layout) : "");
    return advice;
}

std::string advice_sentence(const DistanceAdvice& advice, std::size_t frames) {
    const DistanceTrial& trial = advice.trial;
    const DistanceRow &best = trial.best(), &present = trial.rows[0];
    const std::string where = frames == 1
                                  ? " in frame " + std::to_string(trial.frames[0])
                                  : " over " + std::to_string(trial.frames.size()) + " frames";
    if (&best == &present)
        return "None of " + std::to_string(trial.tried) + " settings costs less" + where +
               " than the present setting.";
    return "Best of " + std::to_string(trial.tried) + " settings" + where + ": " +
           setting_words(best.setting, trial.is_within) +
           format(", with %.3f of the cost of the present setting: N_v ", cost_share(best, trial)) +
           render::change_text(present.work.volume_tests, best.work.volume_tests) + ", N_p " +
           render::change_text(present.work.triangle_tests, best.work.triangle_tests) +
           ". Cost: assumed time of the tests.";
}

Table trial_table(const DistanceAdvice& advice, std::size_t most) {
    const DistanceTrial& trial = advice.trial;
    std::size_t width = 7;
    const auto name = [&](const DistanceRow& row) {
        return setting_words(row.setting, trial.is_within) +
               (&row == trial.rows.data() ? " (present)" : "");
    };
    for (const DistanceRow& row : trial.rows) width = std::max(width, name(row).size());
    Table table({{.title = "setting", .key = "setting", .width = width, .align = Align::left},
                 {.title = "N_v", .key = "n_v", .width = 11, .before = 2},
                 {.title = "/present", .width = 8, .before = 2},
                 {.title = "N_p", .key = "n_p", .width = 9, .before = 2},
                 {.title = "cost", .key = "cost", .width = 7, .before = 2}});
    for (std::size_t i = 0; i < std::min(most + 1, trial.rows.size()); ++i) {
        const DistanceRow& row = trial.rows[i];
        table.add({name(row),
                   {row.work.volume_tests, render::count_text(row.work.volume_tests)},
                   Cell(ratio(static_cast<double>(row.work.volume_tests),
                              static_cast<double>(trial.rows[0].work.volume_tests)),
                        "%.3f"),
                   {row.work.triangle_tests, render::count_text(row.work.triangle_tests)},
                   Cell(cost_share(row, trial), "%.3f")});
    }
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
    return {{"frames", trial.frames},
            {"settings", std::move(rows)},
            {"best", &trial.best() - trial.rows.data()},
            {"given_up", trial.tried - trial.rows.size()},
            {"command", advice.command},
            {"timing", advice.timing}};
}

}  // namespace scb::app
