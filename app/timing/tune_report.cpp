#include "app/timing/tune_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/build_text.h"
#include "app/timing/tune_layout_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/figures/bench_figure.h"
#include "render/figures/volume_titles.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_table_rows = 15, most_bars = 9;

bool has_tests(const TuneSetting& setting) { return setting.volume == VolumeKind::scb; }

/// The columns that say what a setting is.
std::string setting_columns(const TuneSetting& s) {
    return format("  %-10s  %-5s  %-16s  %-11s  %-6s",
                  std::string(volume_kind_name(s.volume)).c_str(),
                  std::string(split_method_name(s.split)).c_str(),
                  has_tests(s) ? overlap_title(s.overlap).c_str() : "",
                  std::string(descent_rule_name(s.descent)).c_str(),
                  has_growth(s.volume) ? std::string(ball_growth_name(s.growth)).c_str() : "");
}

std::string table_row(const SceneTuning& tuning, std::size_t r) {
    const TuneRow &row = tuning.rows[r], &base = tuning.base();
    std::string line =
        setting_columns(row.setting) +
        format(" %11.1f %6.3f %10.1f %6.3f %13.1f %6.3f %7.0f",
               tuning.mean(row.counts.volume_tests),
               multiple_of(row.counts.volume_tests, base.counts.volume_tests),
               tuning.mean(row.counts.triangle_tests),
               multiple_of(row.counts.triangle_tests, base.counts.triangle_tests),
               tuning.mean(row.counts.operations),
               multiple_of(row.counts.operations, base.counts.operations), row.bytes_per_triangle);
    if (tuning.timed()) line += format(" %9.1f", row.build_ms);
    if (row.ms) line += format("  %8.4f [%.4f, %.4f]", row.ms->median, row.ms->low, row.ms->high);
    if (row.misses_pairs) line += "  misses pairs";
    if (const std::size_t equal = tuning.equals(r); equal > 0)
        line += format("  and %zu equal", equal);
    return line + "\n";
}

std::string best_line(const SceneTuning& tuning, const char* what, std::size_t best, double share) {
    std::string line = std::string(what) + ": " + setting_text(tuning.rows[best].setting);
    if (best == 0) return line + ", the base.\n";
    return line + format(", %.3f of the base's.\n", share);
}

std::string time_line(const SceneTuning& tuning) {
    const TuneRow &row = tuning.rows[tuning.least_time], &base = tuning.base();
    std::string line = "Least time: " + setting_text(row.setting);
    line += tuning.least_time == 0
                ? ", the base"
                : format(", %.2f of the base's", ratio(row.ms->median, base.ms->median, 1));
    std::size_t alike = 0;
    for (const TuneRow& other : tuning.rows)
        alike += &other != &row && other.ms && !apart(*other.ms, *row.ms);
    if (alike > 0)
        line += format("; no measurable difference from %zu other%s of those timed", alike,
                       alike == 1 ? "" : "s");
    return line + ".\n";
}

/// "scb2, cost, area": the volume, and what is not as by default, as a bar has room for.
std::string bar_name(const TuneSetting& s) {
    const TuneSetting usual;
    std::string name(volume_kind_name(s.volume));
    const auto add = [&](bool is, const std::string& part) {
        if (is) name += ", " + part;
    };
    add(s.split != usual.split, std::string(split_method_name(s.split)));
    add(has_tests(s) && s.overlap.test != usual.overlap.test, overlap_title(s.overlap));
    add(s.descent != usual.descent, std::string(descent_rule_name(s.descent)));
    add(has_growth(s.volume) && s.growth != usual.growth,
        "growth " + std::string(ball_growth_name(s.growth)));
    return name;
}

std::string count_text(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + (count == 1 ? one : many);
}

}  // namespace

double multiple_of(std::uint64_t count, std::uint64_t base) {
    return ratio(static_cast<double>(count), static_cast<double>(base), 1);
}

std::string setting_options(const TuneSetting& s) {
    const TuneSetting usual;
    std::string text;
    const auto add = [&](bool given, const char* option, std::string_view value) {
        if (given) text += " " + std::string(option) + " " + std::string(value);
    };
    add(s.volume != usual.volume, "--volume", volume_kind_name(s.volume));
    add(s.split != usual.split, "--split", split_method_name(s.split));
    if (has_tests(s)) {
        add(s.overlap.test != usual.overlap.test, "--test", overlap_test_name(s.overlap.test));
        add(has_threshold(s.overlap.test) && s.overlap.threshold != usual.overlap.threshold,
            "--threshold", Json(s.overlap.threshold).dump());
    }
    add(s.descent != usual.descent, "--descent", descent_rule_name(s.descent));
    add(has_growth(s.volume) && s.growth != usual.growth, "--growth", ball_growth_name(s.growth));
    return text;
}

std::string setting_text(const TuneSetting& s) {
    return std::string(volume_kind_name(s.volume)) + ", split " +
           std::string(split_method_name(s.split)) +
           (has_tests(s) ? ", " + overlap_title(s.overlap) : "") + ", descent " +
           std::string(descent_rule_name(s.descent)) +
           (has_growth(s.volume) ? ", growth " + std::string(ball_growth_name(s.growth)) : "");
}

std::string tune_rows_text(const SceneTuning& tuning, std::size_t most) {
    std::string text =
        "  volume      split  test              descent      growth         N_v  /base        N_p  "
        "/base    operations  /base    B/tri";
    if (tuning.timed()) text += "  build ms        ms [least, most]";
    text += "\n" + table_row(tuning, 0);
    const std::vector<std::size_t> listed = tuning.listed(most);
    for (const std::size_t r : listed) text += table_row(tuning, r);
    // What the sentences below speak of, and what was timed.
    for (const std::size_t r : tuning.best)
        if (r != 0 && std::find(listed.begin(), listed.end(), r) == listed.end() &&
            (tuning.rows[r].ms || r == tuning.fewest_operations))
            text += table_row(tuning, r);
    return text + "\n" +
           best_line(tuning, "Fewest volume tests", tuning.best[0],
                     multiple_of(tuning.rows[tuning.best[0]].counts.volume_tests,
                                 tuning.base().counts.volume_tests)) +
           best_line(tuning, "Fewest operations", tuning.fewest_operations,
                     multiple_of(tuning.rows[tuning.fewest_operations].counts.operations,
                                 tuning.base().counts.operations)) +
           (tuning.timed() ? time_line(tuning) : "") + layout_rows_text(tuning, most);
}

std::string tune_table(const SceneTuning& tuning) {
    return tuning.scene + ": " + tuning.bodies[0] + " and " + tuning.bodies[1] +
           format(", %zu and %zu triangles, ", tuning.triangles[0], tuning.triangles[1]) +
           render::frames_text(tuning.frames) + build_text(tuning.build) + "; means per frame\n\n" +
           format("%s counted: the base, then the best first (by N_v, then N_p, then operations)\n",
                  count_text(tuning.rows.size(), " setting", " settings").c_str()) +
           tune_rows_text(tuning, most_table_rows);
}

Json tune_json(const SceneTuning& tuning) {
    Json settings = Json::array();
    for (const TuneRow& row : tuning.rows) {
        const TuneSetting& setting = row.setting;
        Json entry = {{"tuned", tuned_names[tuned(setting, tuning.base().setting)]},
                      {"volume", volume_kind_name(setting.volume)},
                      {"split", split_method_name(setting.split)}};
        if (has_tests(setting)) {
            entry["test"] = overlap_test_name(setting.overlap.test);
            if (has_threshold(setting.overlap.test)) entry["threshold"] = setting.overlap.threshold;
        }
        entry["descent"] = descent_rule_name(setting.descent);
        if (has_growth(setting.volume)) entry["growth"] = ball_growth_name(setting.growth);
        entry["n_v"] = tuning.mean(row.counts.volume_tests);
        entry["n_p"] = tuning.mean(row.counts.triangle_tests);
        entry["operations"] = tuning.mean(row.counts.operations);
        entry["pairs"] = tuning.mean(row.pairs);
        entry["misses_pairs"] = row.misses_pairs;
        entry["bytes_per_triangle"] = row.bytes_per_triangle;
        if (tuning.timed()) entry["build_ms"] = row.build_ms;
        if (row.ms)
            entry.update(
                Json{{"ms", row.ms->median}, {"ms_least", row.ms->low}, {"ms_most", row.ms->high}});
        settings.push_back(std::move(entry));
    }
    Json best = {{"tests", tuning.best[0]},
                 {"operations", tuning.fewest_operations},
                 {"cost", tuning.least_cost}};
    if (tuning.timed()) best["time"] = tuning.least_time;
    if (tuning.quicker_layout) best["layout"] = *tuning.quicker_layout;
    Json json = {{"scene", tuning.scene},
                 {"bodies", tuning.bodies},
                 {"triangles", tuning.triangles},
                 {"frames", tuning.frames}};
    if (tuning.timed()) json["timed_frames"] = tuning.timed_frames;
    json.update(Json{{"volume", volume_kind_name(tuning.base().setting.volume)},
                     {"settings", settings},
                     {"best_first", tuning.best},
                     {"best", best},
                     {"layouts", layouts_json(tuning)}});
    return json;
}

std::string tune_csv(const SceneTuning& tuning) {
    std::string text =
        "tuned,volume,split,test,threshold,descent,growth,n_v,n_p,operations,pairs,misses_pairs,"
        "bytes_per_triangle,build_ms,ms,ms_least,ms_most,layout,leaf\n";
    const auto times = [&](double build_ms, const std::optional<TimeInterval>& ms) {
        return (tuning.timed() ? format("%.3f,", build_ms) : std::string(",")) +
               (ms ? format("%.6f,%.6f,%.6f,", ms->median, ms->low, ms->high) : std::string(",,,"));
    };
    for (const TuneRow& row : tuning.rows) {
        const TuneSetting& s = row.setting;
        const bool threshold = has_tests(s) && has_threshold(s.overlap.test);
        text += std::string(tuned_names[tuned(s, tuning.base().setting)]) + "," +
                std::string(volume_kind_name(s.volume)) + "," +
                std::string(split_method_name(s.split)) + "," +
                std::string(has_tests(s) ? overlap_test_name(s.overlap.test) : "") + "," +
                (threshold ? Json(s.overlap.threshold).dump() : std::string()) + "," +
                std::string(descent_rule_name(s.descent)) + "," +
                std::string(has_growth(s.volume) ? ball_growth_name(s.growth) : "") +
                format(",%.6f,%.6f,%.6f,%.6f,%d,%.3f,", tuning.mean(row.counts.volume_tests),
                       tuning.mean(row.counts.triangle_tests), tuning.mean(row.counts.operations),
                       tuning.mean(row.pairs), row.misses_pairs ? 1 : 0, row.bytes_per_triangle) +
                times(row.build_ms, row.ms) + ",\n";
    }
    for (const TuneLayout& layout : tuning.layouts) {
        const TuneSetting& s = tuning.rows[layout.row].setting;
        text += "layout," + std::string(volume_kind_name(s.volume)) + "," +
                std::string(split_method_name(s.split)) + ",,,," +
                std::string(ball_growth_name(s.growth)) +
                format(",%.6f,%.6f,,%.6f,%d,%.3f,", tuning.mean(layout.n_v),
                       tuning.mean(layout.n_p), tuning.mean(layout.pairs),
                       layout.misses_pairs ? 1 : 0, layout.bytes_per_triangle) +
                times(layout.build_ms, layout.ms) + packed_layout_name(layout.layout) + "," +
                std::to_string(layout.layout.leaf_triangles) + "\n";
    }
    return text;
}

render::TuneFigure tune_figure(const SceneTuning& tuning) {
    const TuneRow& base = tuning.base();
    render::TuneFigure figure;
    figure.title = tuning.scene + " · settings";
    figure.subtitle = render::frames_text(tuning.frames) + ", base: " + setting_text(base.setting);
    const auto times = [&](const TimeInterval& ms) {
        const double of_base = base.ms->median;
        return render::TuneBar::Times{ratio(ms.low, of_base, 1), ratio(ms.median, of_base, 1),
                                      ratio(ms.high, of_base, 1)};
    };
    const auto add = [&](std::size_t r) {
        const TuneRow& row = tuning.rows[r];
        render::TuneBar bar;
        bar.name = r == 0 ? "base" : bar_name(row.setting);
        bar.n_v = multiple_of(row.counts.volume_tests, base.counts.volume_tests);
        bar.operations = multiple_of(row.counts.operations, base.counts.operations);
        if (row.ms) bar.time = times(*row.ms);
        bar.misses_pairs = row.misses_pairs;
        bar.fewest_tests = r == tuning.best[0];
        bar.fewest_operations = r == tuning.fewest_operations;
        bar.least_time = tuning.timed() && r == tuning.least_time;
        figure.bars.push_back(std::move(bar));
    };
    add(0);
    const std::vector<std::size_t> listed = tuning.listed(most_bars);
    for (const std::size_t r : tuning.best)
        if (r != 0 && (std::find(listed.begin(), listed.end(), r) != listed.end() ||
                       r == tuning.fewest_operations || (tuning.timed() && r == tuning.least_time)))
            add(r);
    if (tuning.quicker_layout) {
        const TuneLayout& layout = tuning.layouts[*tuning.quicker_layout];
        for (render::TuneBar& bar : figure.bars) bar.least_time = false;
        render::TuneBar& bar = figure.bars.emplace_back();
        TuneSetting packed;
        packed.volume = tuning.rows[layout.row].setting.volume;
        packed.split = tuning.rows[layout.row].setting.split;
        packed.growth = tuning.rows[layout.row].setting.growth;
        bar.name = bar_name(packed) + ", " + packed_layout_name(layout.layout);
        bar.n_v = multiple_of(layout.n_v, base.counts.volume_tests);
        bar.time = times(*layout.ms);
        bar.least_time = true;
    }
    return figure;
}

}  // namespace scb::app
