#include "app/timing/tune_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/build_text.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/figures/bench_figure.h"
#include "render/figures/volume_titles.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// "symmetric, descent radius, growth ritter": what of it means anything to the volume.
std::string setting_text(const TuneSetting& setting, VolumeKind kind) {
    return (kind == VolumeKind::scb ? overlap_title(setting.overlap) + ", " : "") + "descent " +
           std::string(descent_rule_name(setting.descent)) +
           (has_growth(kind) ? ", growth " + std::string(ball_growth_name(setting.growth)) : "");
}

/// What of the setting is not the base's.
std::string change_text(const TuneTrial& trial, VolumeKind kind) {
    switch (trial.tuned) {
        case Tuned::test:
        case Tuned::threshold:
            return overlap_title(trial.setting.overlap);
        case Tuned::descent:
            return "descent " + std::string(descent_rule_name(trial.setting.descent));
        case Tuned::growth:
            return "growth " + std::string(ball_growth_name(trial.setting.growth));
        default:
            return setting_text(trial.setting, kind);
    }
}

const char* group_title(Tuned tuned) {
    switch (tuned) {
        case Tuned::nothing:
            return "base";
        case Tuned::test:
            return "other overlap tests";
        case Tuned::threshold:
            return "other thresholds a of corrected";
        case Tuned::descent:
            return "other descent rules";
        case Tuned::growth:
            return "other growth of balls";
        case Tuned::several:
            break;
    }
    return "the best of each together";
}

std::string table_row(const TuneRow& row, const TuneRow& base, VolumeKind kind, bool timed) {
    std::string line =
        format("  %-46s %10.1f %9.1f %12.1f %6.2f", change_text(row.trial, kind).c_str(), row.n_v,
               row.n_p, row.operations, ratio(row.operations, base.operations, 1));
    if (timed) line += format(" %9.4f %6.2f", row.ms, ratio(row.ms, base.ms, 1));
    return line + (row.misses_pairs ? "  misses pairs\n" : "\n");
}

std::string best_line(const char* what, const SceneTuning& tuning, std::size_t best,
                      double TuneRow::*cost) {
    const TuneRow &row = tuning.rows[best], &base = tuning.rows[0];
    std::string line = std::string(what) + ": " + setting_text(row.trial.setting, tuning.kind);
    if (best == 0) return line + ", the base\n";
    return line + format(", %.2f of the base's\n", ratio(row.*cost, base.*cost, 1));
}

/// The volume, unless it is the usual one.
std::string of_volume(const SceneTuning& tuning, const char* separator) {
    if (tuning.kind == VolumeKind::scb) return "";
    return std::string(render::volume_title(tuning.kind)) + separator;
}

std::string bar_name(const SceneTuning& tuning, const TuneRow& row) {
    if (row.trial.tuned == Tuned::nothing) return "base";
    if (row.trial.tuned != Tuned::several) return change_text(row.trial, tuning.kind);
    const TuneSetting& setting = row.trial.setting;
    const TuneSetting& base = tuning.rows[0].trial.setting;
    // What it changes is more than a bar has room for.
    std::string name;
    const auto add = [&](const std::string& part) { name += (name.empty() ? "" : ", ") + part; };
    if (!(TuneSetting{setting.overlap, base.descent, base.growth} == base))
        add(overlap_title(setting.overlap));
    if (setting.descent != base.descent) add(std::string(descent_rule_name(setting.descent)));
    if (setting.growth != base.growth) add(std::string(ball_growth_name(setting.growth)));
    return name;
}

}  // namespace

std::string tune_table(const SceneTuning& tuning) {
    std::string text =
        tuning.scene + ": " + tuning.bodies[0] + " and " + tuning.bodies[1] +
        format(", %zu and %zu triangles, ", tuning.triangles[0], tuning.triangles[1]) +
        of_volume(tuning, ", ") + render::frames_text(tuning.frames) + build_text(tuning.build) +
        "; means per frame\n\n" +
        "  setting                                               N_v       N_p   operations / base";
    text += tuning.timed ? "        ms / base\n" : "\n";
    const TuneRow& base = tuning.rows[0];
    Tuned group = Tuned::nothing;
    for (const TuneRow& row : tuning.rows) {
        if (&row == &base || row.trial.tuned != group)
            text += std::string(group_title(row.trial.tuned)) + "\n";
        group = row.trial.tuned;
        text += table_row(row, base, tuning.kind, tuning.timed);
    }
    text += "\n" +
            best_line("Fewest operations", tuning, tuning.fewest_operations, &TuneRow::operations);
    if (tuning.timed) text += best_line("Least time", tuning, tuning.least_time, &TuneRow::ms);
    return text;
}

Json tune_json(const SceneTuning& tuning) {
    Json settings = Json::array();
    for (const TuneRow& row : tuning.rows) {
        const TuneSetting& setting = row.trial.setting;
        Json entry = {{"tuned", tuned_names[row.trial.tuned]}};
        if (tuning.kind == VolumeKind::scb) {
            entry["test"] = overlap_test_name(setting.overlap.test);
            if (has_threshold(setting.overlap.test)) entry["threshold"] = setting.overlap.threshold;
        }
        entry["descent"] = descent_rule_name(setting.descent);
        if (has_growth(tuning.kind)) entry["growth"] = ball_growth_name(setting.growth);
        entry["n_v"] = row.n_v;
        entry["n_p"] = row.n_p;
        entry["operations"] = row.operations;
        entry["pairs"] = row.pairs;
        entry["misses_pairs"] = row.misses_pairs;
        if (tuning.timed) entry["ms"] = row.ms;
        settings.push_back(std::move(entry));
    }
    Json best = {{"operations", tuning.fewest_operations}};
    if (tuning.timed) best["time"] = tuning.least_time;
    return {{"scene", tuning.scene},
            {"bodies", tuning.bodies},
            {"triangles", tuning.triangles},
            {"frames", tuning.frames},
            {"volume", volume_kind_name(tuning.kind)},
            {"settings", settings},
            {"best", best}};
}

std::string tune_csv(const SceneTuning& tuning) {
    std::string text =
        "tuned,test,threshold,descent,growth,n_v,n_p,operations,pairs,misses_pairs,ms\n";
    for (const TuneRow& row : tuning.rows) {
        const TuneSetting& setting = row.trial.setting;
        const bool test = tuning.kind == VolumeKind::scb,
                   threshold = test && has_threshold(setting.overlap.test);
        text += std::string(tuned_names[row.trial.tuned]) + "," +
                std::string(test ? overlap_test_name(setting.overlap.test) : "") + "," +
                (threshold ? Json(setting.overlap.threshold).dump() : std::string()) + "," +
                std::string(descent_rule_name(setting.descent)) + "," +
                std::string(has_growth(tuning.kind) ? ball_growth_name(setting.growth) : "") +
                format(",%.6f,%.6f,%.6f,%.6f,%d,", row.n_v, row.n_p, row.operations, row.pairs,
                       row.misses_pairs ? 1 : 0) +
                (tuning.timed ? format("%.6f\n", row.ms) : std::string("\n"));
    }
    return text;
}

render::TuneFigure tune_figure(const SceneTuning& tuning) {
    const TuneRow& base = tuning.rows[0];
    render::TuneFigure figure;
    figure.title = tuning.scene + " · " + of_volume(tuning, " · ") + "settings";
    figure.subtitle = render::frames_text(tuning.frames) +
                      ", base: " + setting_text(base.trial.setting, tuning.kind);
    std::vector<std::pair<double, render::TuneCosts>> points;
    for (std::size_t i = 0; i < tuning.rows.size(); ++i) {
        const TuneRow& row = tuning.rows[i];
        render::TuneCosts costs{
            ratio(row.n_v, base.n_v, 1), ratio(row.operations, base.operations, 1), {}};
        if (tuning.timed) costs.time = ratio(row.ms, base.ms, 1);
        const TuneSetting& setting = row.trial.setting;
        if (tuning.kind == VolumeKind::scb && setting.overlap.test == OverlapTest::corrected &&
            setting.descent == base.trial.setting.descent &&
            setting.growth == base.trial.setting.growth)
            points.emplace_back(setting.overlap.threshold, costs);
        if (row.trial.tuned == Tuned::threshold) continue;
        figure.bars.push_back({bar_name(tuning, row), costs, row.misses_pairs,
                               i == tuning.fewest_operations,
                               tuning.timed && i == tuning.least_time});
    }
    std::sort(points.begin(), points.end(),
              [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& [threshold, costs] : points) {
        figure.thresholds.push_back(threshold);
        figure.over_threshold.push_back(costs);
    }
    return figure;
}

}  // namespace scb::app
