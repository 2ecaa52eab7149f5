#include "app/inspect/settings_page.h"

#include "app/report/wrapped_text.h"
#include "app/timing/tune_layout_report.h"
#include "app/timing/tune_report.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/inspect_figure.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using kainjow::mustache::data;

data setting_rows(const InspectSettings& settings) {
    const SceneTuning& tuning = settings.tuning;
    const Work& from = settings.recorded ? *settings.recorded : tuning.base().counts;
    const TuneLayout* const cheapest = tuning.cheapest_layout();
    data rows(data::type::list);
    const auto add = [&](std::size_t r) {
        const TuneRow& found = tuning.rows[r];
        data row;
        row["setting"] =
            (r == 0 && !settings.recorded ? "present: " : "") + setting_text(found.setting);
        row["best"] = flag(!cheapest && r == tuning.recommended());
        set_changes(row, from, found.counts);
        if (settings.recorded) {
            row["operations_change"] = "";
            row["cost_change"] = "";
        }
        row["bytes"] = format("%.0f", found.bytes_per_triangle);
        row["ms"] = found.ms ? interval_text(tuning, *found.ms) : std::string();
        rows << row;
    };
    if (settings.recorded) {
        data row;
        row["setting"] = "recorded: " + printable(settings.engine);
        row["n_v"] = render::count_text(from.volume_tests);
        row["n_p"] = render::count_text(from.triangle_tests);
        row["operations"] = "–";
        row["cost"] = "–";
        row["best"] = flag(false);
        rows << row;
    } else {
        add(0);
    }
    if (cheapest) {
        data row;
        row["setting"] = layout_text(tuning, *cheapest) + ", packed";
        row["best"] = flag(true);
        set_changes(row, from, {cheapest->n_v, cheapest->n_p, 0, cheapest->picoseconds});
        // Operations of packed tests are not counted.
        row["operations"] = "–";
        row["operations_change"] = "";
        if (settings.recorded) row["cost_change"] = "";
        row["bytes"] = format("%.0f", cheapest->bytes_per_triangle);
        rows << row;
    }
    for (const std::size_t r : listed_settings(settings)) add(r);
    return rows;
}

void set_tuning(data& values, const InspectSettings& settings, std::size_t frames) {
    const SceneTuning& tuning = settings.tuning;
    values["settings"] = setting_rows(settings);
    values["settings_words"] = settings_words(tuning, frames, "sums over");
    values["cost_words"] = cost_words;
    values["best_words"] = settings.recorded
                               ? "Changes are relative to the recorded tests."
                               : best_sentences(tuning, "the present setting").front();
    const TuneLayout* const cheapest = tuning.cheapest_layout();
    values["use"] = cheapest ? settings.layout_command : settings.command;
    if (cheapest) values["code"] = layout_code(tuning, *cheapest);
    const std::string packed = layout_sentence(tuning);
    if (!packed.empty()) values["packed"] = packed;
    if (!settings.layout_command.empty()) values["use_packed"] = settings.layout_command;
    values["timed"] = flag(tuning.timed());
}

}  // namespace

data flag(bool is_set) { return data(is_set ? data::type::bool_true : data::type::bool_false); }

/// The work of a query, and its change.
void set_changes(data& row, const Work& from, const Work& to) {
    row["n_v"] = render::count_text(to.volume_tests);
    row["n_v_change"] = render::change_text(from.volume_tests, to.volume_tests);
    row["n_p"] = render::count_text(to.triangle_tests);
    row["n_p_change"] = render::change_text(from.triangle_tests, to.triangle_tests);
    row["operations"] = render::count_text(to.operations);
    row["operations_change"] = render::change_text(from.operations, to.operations);
    row["cost"] = render::count_text(to.picoseconds / 1000);
    row["cost_change"] = render::change_text(from.picoseconds, to.picoseconds);
}

void set_settings(data& values, const InspectReport& report) {
    values["has_settings"] = flag(report.settings.has_value());
    values["has_distance_settings"] = flag(report.distance_advice.has_value());
    if (report.distance_advice) {
        values["distance_settings"] = trial_table(*report.distance_advice, most_trial_rows).html();
        values["distance_words"] = trial_words(*report.distance_advice);
        values["distance_command"] = report.distance_advice->command;
        values["distance_timing"] = report.distance_advice->timing;
    }
    if (report.settings) set_tuning(values, *report.settings, report.frames.size());
}

}  // namespace scb::app
