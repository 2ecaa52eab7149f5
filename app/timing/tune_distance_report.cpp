#include "app/timing/tune_distance_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/build_text.h"
#include "app/report/trace_report.h"
#include "app/study/distance_setting_text.h"
#include "app/timing/bench_report.h"
#include "app/timing/tune_layout_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/figures/bench_figure.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// "depth-first"; empty for queries without an order.
std::string order_text(const DistanceTuning& tuning, const DistanceSetting& setting) {
    return tuning.asked.within ? "" : std::string(distance_order_name(setting.order));
}

std::string ms_text(const DistanceTuning& tuning, const TimeInterval& ms) {
    return tuning.runs == 1 ? format("%.4f", ms.median)
                            : format("%.4f [%.4f, %.4f]", ms.median, ms.low, ms.high);
}

double time_of_base(const DistanceTuning& tuning, const TimedSetting& row) {
    return ratio(row.ms.median, tuning.base().ms.median, 1);
}

std::string row_text(const DistanceTuning& tuning, const TimedSetting& row) {
    const DistanceSetting& s = row.setting;
    const auto mean = [&](std::uint64_t sum) {
        return right_aligned(render::mean_text(sum, tuning.frames.size()), 12);
    };
    const std::string layout = s.layout ? packed_layout_name(*s.layout) : "reference";
    const bool is_base = &row == &tuning.base(), is_best = &row == &tuning.rows[tuning.best()];
    return format("  %-10s  %-9s  %-11s  %-10s  %4s",
                  std::string(volume_kind_name(s.hierarchy.volume)).c_str(),
                  std::string(split_method_name(s.hierarchy.split)).c_str(),
                  order_text(tuning, s).c_str(), layout.c_str(),
                  s.layout ? std::to_string(s.layout->leaf_triangles).c_str() : "") +
           mean(row.n_v) + mean(row.n_p) +
           format(" %7.0f %9.1f  %7.3f  ", row.bytes_per_triangle, row.build_ms,
                  time_of_base(tuning, row)) +
           ms_text(tuning, row.ms) + (is_base ? "  base" : "") + (is_best ? "  best" : "") + "\n";
}

/// Counts the timed settings without a measurable difference from the row.
std::string alike_text(const DistanceTuning& tuning, const TimedSetting& row) {
    if (tuning.runs == 1) return "; one run shows no small differences, and --repeat 5 does";
    std::size_t alike = 0;
    for (const TimedSetting& other : tuning.rows)
        alike += &other != &row && !apart(other.ms, row.ms);
    if (alike == 0) return "";
    return format("; no measurable difference from %zu other%s of those timed", alike,
                  alike == 1 ? "" : "s");
}

std::string best_text(const DistanceTuning& tuning) {
    const TimedSetting& best = tuning.rows[tuning.best()];
    const bool is_within = tuning.asked.within.has_value();
    std::string text = format("Best of %zu settings: ", tuning.tried);
    if (tuning.best() == 0)
        return text + "the base, " + setting_words(best.setting, is_within) +
               ": of those timed none is " + (tuning.runs == 1 ? "" : "measurably ") + "quicker, " +
               ms_text(tuning, best.ms) + " ms" + alike_text(tuning, best) + ".\n";
    text += setting_words(best.setting, is_within) +
            format(", with %.3f of the time of the base, ", time_of_base(tuning, best)) +
            ms_text(tuning, best.ms) + " ms against " + ms_text(tuning, tuning.base().ms) +
            alike_text(tuning, best) + ".\n";
    const std::size_t unpacked = tuning.best_unpacked();
    if (unpacked == tuning.best()) return text;
    if (unpacked == 0)
        return text + "Unpacked: of those timed none is " +
               (tuning.runs == 1 ? "" : "measurably ") + "quicker than the base.\n";
    return text + "Unpacked: " + setting_words(tuning.rows[unpacked].setting, is_within) +
           format(", with %.3f of the time of the base.\n",
                  time_of_base(tuning, tuning.rows[unpacked]));
}

std::string asked_words(const DistanceQuery& asked) {
    if (asked.within) return format("triangles at most %g apart", *asked.within);
    std::string text = "the smallest distance";
    if (asked.limits.relative_error > 0)
        text += format(", relative error up to %g", asked.limits.relative_error);
    if (std::isfinite(asked.limits.limit)) text += format(", limit %g", asked.limits.limit);
    return text;
}

}  // namespace

std::string distance_code(const DistanceTuning& tuning, const DistanceSetting& setting) {
    const std::string packed = setting.layout ? "_packed" : "";
    const std::string build = setting.layout
                                  ? packed_code(tuning.build, setting.hierarchy, *setting.layout)
                                  : hierarchy_code(tuning.build, setting.hierarchy);
    const bool gives_descent =
        !setting.layout && setting.hierarchy.descent != DistanceOptions{}.descent;
    const std::string descent =
        "scb::DescentRule::" + std::string(descent_rule_name(setting.hierarchy.descent));
    if (tuning.asked.within)
        return build + "; scb::within" + packed + "(a, b, b_to_a, " +
               exact_number(*tuning.asked.within) + (gives_descent ? ", " + descent : "") + ")";
    std::string options;
    const auto add = [&](bool given, const char* field, const std::string& value) {
        if (given) options += (options.empty() ? "." : ", .") + std::string(field) + " = " + value;
    };
    std::string order(distance_order_name(setting.order));
    std::replace(order.begin(), order.end(), '-', '_');
    const DistanceOptions& limits = tuning.asked.limits;
    add(setting.order != DistanceOptions{}.order, "order", "scb::DistanceOrder::" + order);
    add(gives_descent, "descent", descent);
    add(limits.relative_error > 0, "relative_error", exact_number(limits.relative_error));
    add(std::isfinite(limits.limit), "limit", exact_number(limits.limit));
    return build + "; scb::distance" + packed + "(a, b, b_to_a" +
           (options.empty() ? "" : ", {" + options + "}") + ")";
}

std::string distance_tune_table(const DistanceTuning& tuning) {
    std::string text =
        tuning.scene + ": " + tuning.bodies[0] + " and " + tuning.bodies[1] +
        format(", %s and %s triangles, ", render::count_text(tuning.triangles[0]).c_str(),
               render::count_text(tuning.triangles[1]).c_str()) +
        render::frames_text(tuning.frames) + build_text(tuning.build) + "; " +
        asked_words(tuning.asked) + "; means per frame\n\n" +
        format("%zu settings tried, and the quickest timed: the base, then the quickest first\n",
               tuning.tried) +
        "  volume      split      order        layout      leaf         N_v         N_p   B/tri  "
        "build ms    /base  " +
        (tuning.runs == 1 ? "ms, one run" : "ms [least, most]") + "\n";
    for (const TimedSetting& row : tuning.rows) text += row_text(tuning, row);
    text += "\n" + best_text(tuning);
    return text + (tuning.no_layouts.empty() ? "" : tuning.no_layouts + "\n");
}

Json distance_tune_json(const DistanceTuning& tuning) {
    const auto mean = [&](std::uint64_t sum) {
        return static_cast<double>(sum) / static_cast<double>(tuning.frames.size());
    };
    Json settings = Json::array();
    for (const TimedSetting& row : tuning.rows) {
        const DistanceSetting& setting = row.setting;
        const TuneSetting& hierarchy = setting.hierarchy;
        Json entry = {{"volume", volume_kind_name(hierarchy.volume)},
                      {"split", split_method_name(hierarchy.split)}};
        if (has_growth(hierarchy.volume)) entry["growth"] = ball_growth_name(hierarchy.growth);
        if (!tuning.asked.within) entry["order"] = distance_order_name(setting.order);
        if (setting.layout) {
            entry["layout"] = packed_layout_name(*setting.layout);
            entry["leaf"] = setting.layout->leaf_triangles;
        } else {
            entry["layout"] = "reference";
            entry["descent"] = descent_rule_name(hierarchy.descent);
        }
        entry.update(Json{{"n_v", mean(row.n_v)},
                          {"n_p", mean(row.n_p)},
                          {"bytes_per_triangle", row.bytes_per_triangle},
                          {"build_ms", row.build_ms},
                          {"ms", row.ms.median},
                          {"ms_least", row.ms.low},
                          {"ms_most", row.ms.high}});
        settings.push_back(std::move(entry));
    }
    return {{"scene", tuning.scene},
            {"bodies", tuning.bodies},
            {"triangles", tuning.triangles},
            {"query", query_kind_name(tuning.asked.kind())},
            {"asked", asked_json(tuning.asked)},
            {"timed_frames", tuning.frames},
            {"tried", tuning.tried},
            {"settings", settings},
            {"best", {{"recommended", tuning.best()}, {"unpacked", tuning.best_unpacked()}}}};
}

}  // namespace scb::app
