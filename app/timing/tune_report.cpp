#include "app/timing/tune_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/report/build_text.h"
#include "app/report/scene_report.h"
#include "app/timing/tune_layout_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/figures/bench_figure.h"
#include "render/figures/figure_words.h"
#include "render/figures/inspect_figure.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_table_rows = 15, most_bars = 9;

bool has_tests(const TuneSetting& setting) { return setting.volume == VolumeKind::scb; }

/// The columns of a setting's options.
std::string setting_columns(const TuneSetting& s) {
    return format("  %-10s  %-5s  %-16s  %-11s  %-6s",
                  std::string(volume_kind_name(s.volume)).c_str(),
                  std::string(split_method_name(s.split)).c_str(),
                  has_tests(s) ? overlap_title(s.overlap).c_str() : "",
                  std::string(descent_rule_name(s.descent)).c_str(),
                  has_growth(s.volume) ? std::string(ball_growth_name(s.growth)).c_str() : "");
}

/// Marks the base and the recommended row.
std::string mark(const SceneTuning& tuning, std::size_t r) {
    return std::string(r == 0 ? "  base" : "") + (r == tuning.recommended() ? "  best" : "");
}

double cost_of_base(const SceneTuning& tuning, std::size_t r) {
    return multiple_of(tuning.rows[r].counts.picoseconds, tuning.base().counts.picoseconds);
}

std::string table_row(const SceneTuning& tuning, std::size_t r) {
    const TuneRow &row = tuning.rows[r], &base = tuning.base();
    const auto mean = [&](std::size_t width, std::uint64_t sum) {
        return right_aligned(render::mean_text(sum, tuning.frames.size()), width);
    };
    std::string line =
        setting_columns(row.setting) + mean(12, row.counts.volume_tests) +
        format(" %6.3f", multiple_of(row.counts.volume_tests, base.counts.volume_tests)) +
        mean(12, row.counts.triangle_tests) +
        format(" %6.3f", multiple_of(row.counts.triangle_tests, base.counts.triangle_tests)) +
        mean(15, row.counts.operations) +
        format(" %7.3f %7.0f", cost_of_base(tuning, r), row.bytes_per_triangle);
    if (tuning.timed()) line += format(" %9.1f", row.build_ms);
    if (row.ms) line += "  " + interval_text(tuning, *row.ms);
    if (row.misses_pairs) line += "  misses pairs";
    if (const std::size_t equal = tuning.equals(r); equal > 0)
        line += format("  and %zu equal", equal);
    return line + mark(tuning, r) + "\n";
}

/// "0.047 of the cost of the base (-95.3 %)".
std::string cost_text(const SceneTuning& tuning, std::uint64_t cost, const std::string& base) {
    const std::uint64_t of_base = tuning.base().counts.picoseconds;
    return format("%.3f of the cost of ", multiple_of(cost, of_base)) + base + " (" +
           render::change_text(of_base, cost) + ")";
}
std::string row_cost_text(const SceneTuning& tuning, std::size_t r, const std::string& base) {
    return cost_text(tuning, tuning.rows[r].counts.picoseconds, base);
}

/// Counts the timed settings without a measurable difference from the best.
std::string alike_text(const SceneTuning& tuning) {
    if (tuning.runs == 1)
        return "; one run, which cannot tell small differences from none: --repeat 5 can";
    const TuneRow& best = tuning.rows[tuning.least_time];
    std::size_t alike = 0;
    for (const TuneRow& other : tuning.rows)
        alike += &other != &best && other.ms && !apart(*other.ms, *best.ms);
    if (alike == 0) return "";
    return format("; no measurable difference from %zu other%s of those timed", alike,
                  alike == 1 ? "" : "s");
}

std::string best_text(const SceneTuning& tuning, const std::string& base) {
    const std::size_t best = tuning.recommended();
    const TuneRow& row = tuning.rows[best];
    const std::size_t settings = tuning.rows.size() + tuning.given_up;
    if (const TuneLayout* const layout = tuning.cheapest_layout()) {
        return format("Best of %zu settings and %zu packed layouts: ", settings,
                      tuning.layouts.size()) +
               layout_text(tuning, *layout) + ", packed, with " +
               cost_text(tuning, layout->picoseconds, base) + "; unpacked: " +
               (best == 0 ? base
                          : setting_text(row.setting) + ", with " +
                                format("%.3f", cost_of_base(tuning, best))) +
               ".";
    }
    std::string text = "Best of " + std::to_string(settings) + " settings: ";
    if (best == 0) text += base + ", ";
    text += setting_text(row.setting);
    if (!tuning.timed())
        return text + (best == 0 ? ": none costs less."
                                 : ", with " + row_cost_text(tuning, best, base) + ".");
    const TimeInterval &ms = *row.ms, &of_base = *tuning.base().ms;
    text += best == 0 ? std::string(": of those timed none is measurably quicker, ")
                      : format(", with %.2f of the time of ", ratio(ms.median, of_base.median, 1)) +
                            base + ", ";
    text += interval_text(tuning, ms) + " ms";
    if (best != 0) text += " against " + interval_text(tuning, of_base);
    return text + alike_text(tuning) + ".";
}

/// "scb2, split cost, descent area": the volume, and options that differ from the default.
std::string bar_name(const TuneSetting& s) {
    const TuneSetting usual;
    std::string name(volume_kind_name(s.volume));
    const auto add = [&](bool is, const std::string& part) {
        if (is) name += ", " + part;
    };
    add(s.split != usual.split, "split " + std::string(split_method_name(s.split)));
    add(has_tests(s) && s.overlap.test != usual.overlap.test, overlap_title(s.overlap));
    add(s.descent != usual.descent, "descent " + std::string(descent_rule_name(s.descent)));
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

std::string interval_text(const SceneTuning& tuning, const TimeInterval& ms) {
    return tuning.runs == 1 ? format("%.4f", ms.median)
                            : format("%.4f [%.4f, %.4f]", ms.median, ms.low, ms.high);
}

std::vector<std::string> best_sentences(const SceneTuning& tuning, const std::string& base) {
    std::vector<std::string> sentences = {best_text(tuning, base)};
    const std::size_t recommended = tuning.recommended(), cheapest = tuning.best[0],
                      fewest = tuning.fewest_tests.value_or(0);
    const auto time = [&](std::size_t r) {
        const TuneRow& row = tuning.rows[r];
        return row.ms ? format(", and %.2f of its time",
                               ratio(row.ms->median, tuning.base().ms->median, 1))
                      : std::string();
    };
    if (cheapest != recommended)
        sentences.push_back("Least cost: " +
                            (cheapest == 0 ? base + "."
                                           : setting_text(tuning.rows[cheapest].setting) +
                                                 ", with " + row_cost_text(tuning, cheapest, base) +
                                                 time(cheapest) + "."));
    if (fewest != recommended && fewest != cheapest && fewest != 0)
        sentences.push_back(
            "Fewest volume tests: " + setting_text(tuning.rows[fewest].setting) +
            format(", %.3f of those of ", multiple_of(tuning.rows[fewest].counts.volume_tests,
                                                      tuning.base().counts.volume_tests)) +
            base + ", but with " + row_cost_text(tuning, fewest, base) + time(fewest) + ".");
    return sentences;
}

std::string tune_rows_text(const SceneTuning& tuning, std::size_t most, const std::string& base) {
    std::string text =
        "  volume      split  test              descent      growth          N_v  /base         "
        "N_p  /base     operations    cost   B/tri";
    if (tuning.timed())
        text += tuning.runs == 1 ? "  build ms  ms, one run" : "  build ms      ms [least, most]";
    text += "\n" + table_row(tuning, 0);
    const std::vector<std::size_t> listed = tuning.listed(most);
    // Also list the rows that were timed or that the sentences below name.
    for (const std::size_t r : tuning.best)
        if (r != 0 && (std::find(listed.begin(), listed.end(), r) != listed.end() ||
                       tuning.rows[r].ms || r == tuning.fewest_tests))
            text += table_row(tuning, r);
    text += "\n";
    for (const std::string& sentence : best_sentences(tuning, base)) text += sentence + "\n";
    return text + layout_rows_text(tuning, most);
}

std::string tune_table(const SceneTuning& tuning) {
    return tuning.scene + ": " + tuning.bodies[0] + " and " + tuning.bodies[1] +
           format(", %s and %s triangles, ", render::count_text(tuning.triangles[0]).c_str(),
                  render::count_text(tuning.triangles[1]).c_str()) +
           render::frames_text(tuning.frames) + build_text(tuning.build) + "; means per frame\n\n" +
           count_text(tuning.rows.size(), " setting", " settings") +
           " counted: the base, then by cost, the least first\ncost: " + cost_words +
           ", relative to the cost of the base\n" +
           tune_rows_text(tuning, most_table_rows, "the base");
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
        entry["cost"] = tuning.mean(row.counts.picoseconds) / 1000;
        entry["pairs"] = tuning.mean(row.pairs);
        entry["misses_pairs"] = row.misses_pairs;
        entry["bytes_per_triangle"] = row.bytes_per_triangle;
        if (tuning.timed()) entry["build_ms"] = row.build_ms;
        if (row.ms)
            entry.update(
                Json{{"ms", row.ms->median}, {"ms_least", row.ms->low}, {"ms_most", row.ms->high}});
        settings.push_back(std::move(entry));
    }
    Json best = Json::object();
    if (tuning.fewest_tests) best["tests"] = *tuning.fewest_tests;
    if (tuning.fewest_operations) best["operations"] = *tuning.fewest_operations;
    best["cost"] = tuning.best[0];
    best["recommended"] = tuning.recommended();
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
    figure.title = scene_title(tuning.scene, tuning.bodies[0], tuning.bodies[1]) + " · settings";
    figure.subtitle = render::frames_text(tuning.frames) + ", base: " + setting_text(base.setting);
    const auto times = [&](const TimeInterval& ms) {
        const double of_base = base.ms->median;
        return render::TuneBar::Times{ratio(ms.low, of_base, 1), ratio(ms.median, of_base, 1),
                                      ratio(ms.high, of_base, 1)};
    };
    figure.runs = tuning.runs;
    const auto add = [&](std::size_t r) {
        const TuneRow& row = tuning.rows[r];
        // Both halves of the figure show the same rows.
        if (tuning.timed() && !row.ms) return;
        render::TuneBar bar;
        bar.name = (r == 0 ? "base: " : "") + bar_name(row.setting);
        bar.n_v = multiple_of(row.counts.volume_tests, base.counts.volume_tests);
        bar.cost = cost_of_base(tuning, r);
        if (row.ms) bar.time = times(*row.ms);
        bar.misses_pairs = row.misses_pairs;
        bar.recommended = r == tuning.recommended();
        bar.alike = !bar.recommended && row.ms && tuning.runs > 1 &&
                    !apart(*row.ms, *tuning.rows[tuning.least_time].ms);
        figure.bars.push_back(std::move(bar));
    };
    add(0);
    for (const std::size_t r : tuning.listed(most_bars)) add(r);
    if (tuning.quicker_layout) {
        const TuneLayout& layout = tuning.layouts[*tuning.quicker_layout];
        TuneSetting packed;
        packed.volume = tuning.rows[layout.row].setting.volume;
        packed.split = tuning.rows[layout.row].setting.split;
        packed.growth = tuning.rows[layout.row].setting.growth;
        render::TuneBar& bar = figure.bars.emplace_back();
        bar.name = "packed: " + bar_name(packed) + ", " + packed_layout_name(layout.layout);
        bar.n_v = multiple_of(layout.n_v, base.counts.volume_tests);
        if (layout.picoseconds > 0)
            bar.cost = multiple_of(layout.picoseconds, base.counts.picoseconds);
        else
            bar.cost.reset();
        if (layout.ms) bar.time = times(*layout.ms);
        bar.packed = true;
    }
    return figure;
}

}  // namespace scb::app
