#include "app/timing/tune_layout_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/timing/tune_report.h"
#include "core/base/statistics.h"
#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "scb/packed_hierarchy.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// "scb2, split cost": the settings that affect hierarchies. Test and descent do not.
std::string packed_text(const TuneSetting& s) {
    return std::string(volume_kind_name(s.volume)) + ", split " +
           std::string(split_method_name(s.split)) +
           (s.growth != TuneSetting{}.growth ? ", growth " + std::string(ball_growth_name(s.growth))
                                             : "");
}

/// "{.fit = {.margin = 0.1}, .split = scb::SplitMethod::cost}": the BuildOptions of the setting.
/// Empty if they are the default ones with the split `usual`.
std::string build_code(const BuildOptions& options, const TuneSetting& setting, SplitMethod usual) {
    const double margin = options.fit.margin;
    std::string fit;
    const auto add = [&fit](const std::string& field) { fit += (fit.empty() ? "" : ", ") + field; };
    if (has_growth(setting.volume) && setting.growth != TuneSetting{}.growth)
        add(".growth = scb::BallGrowth::radius");
    if (setting.volume == VolumeKind::ritter) add(".ball_method = scb::BallMethod::ritter");
    if (has_margin(setting.volume) && margin != 0) add(".margin = " + Json(margin).dump());
    if (setting.split == usual && fit.empty()) return "";
    return "{" + (fit.empty() ? "" : ".fit = {" + fit + "}, ") + ".split = scb::SplitMethod::" +
           (setting.split == SplitMethod::cost ? "cost}" : "section_3}");
}

std::string row_text(const SceneTuning& tuning, const TuneLayout& layout) {
    const Work& unpacked = tuning.rows[layout.row].counts;
    const auto mean = [&](std::uint64_t sum) {
        return right_aligned(render::mean_text(sum, tuning.frames.size()), 12);
    };
    std::string line =
        format("  %-10s  %4d", packed_layout_name(layout.layout).c_str(),
               layout.layout.leaf_triangles) +
        mean(layout.n_v) + format(" %9.3f", multiple_of(layout.n_v, unpacked.volume_tests)) +
        mean(layout.n_p) + format(" %9.3f", multiple_of(layout.n_p, unpacked.triangle_tests)) +
        (layout.picoseconds == 0
             ? std::string("       -")
             : format(" %7.3f",
                      multiple_of(layout.picoseconds, tuning.base().counts.picoseconds))) +
        format(" %7.0f", layout.bytes_per_triangle);
    if (layout.ms) line += format(" %9.1f  ", layout.build_ms) + interval_text(tuning, *layout.ms);
    return line + (layout.misses_pairs ? "  misses pairs" : "") + "\n";
}

}  // namespace

std::string layout_text(const SceneTuning& tuning, const TuneLayout& layout) {
    return packed_text(tuning.rows[layout.row].setting) + ", " + packed_layout_name(layout.layout) +
           (layout.layout.leaf_triangles == most_leaf_triangles
                ? ""
                : format(" with leaves of %d", layout.layout.leaf_triangles));
}

std::string recommended_text(const SceneTuning& tuning) {
    const TuneLayout* const layout = tuning.cheapest_layout();
    return layout ? layout_text(tuning, *layout) + ", packed"
                  : setting_text(tuning.rows[tuning.recommended()].setting);
}

std::string layout_options(const SceneTuning& tuning, const TuneLayout& layout) {
    TuneSetting setting;
    setting.split = tuning.rows[layout.row].setting.split;
    setting.growth = tuning.rows[layout.row].setting.growth;
    // `scb bench` has other default volumes.
    std::string text = " --volume " +
                       std::string(volume_kind_name(tuning.rows[layout.row].setting.volume)) +
                       setting_options(setting) + " --layout " + packed_layout_name(layout.layout);
    if (layout.layout.leaf_triangles != most_leaf_triangles)
        text += " --leaf " + std::to_string(layout.layout.leaf_triangles);
    return text;
}

std::string packed_code(const BuildOptions& options, const TuneSetting& setting,
                        const PackedLayout& layout) {
    const bool is_quantized = layout.numbers == PackedLayout::Numbers::quantized,
               is_indexed = layout.corners == LeafCorners::in_mesh;
    const bool gives_leaf = is_indexed || layout.leaf_triangles != most_leaf_triangles;
    const std::string build = build_code(options, setting, packed_build.split);
    std::string code =
        "scb::build_packed<scb::" + std::string(is_quantized ? "QuantizedCodec" : "FloatCodec") +
        "<" + std::to_string(layout.width) +
        (setting.volume == VolumeKind::scb2 ? ", scb::Scb2" : "") + ">>(mesh";
    if (!build.empty())
        code += ", " + build;
    else if (gives_leaf)
        code += ", scb::packed_build";
    if (gives_leaf) code += ", " + std::to_string(layout.leaf_triangles);
    return code + (is_indexed ? ", scb::LeafCorners::in_mesh)" : ")");
}

std::string layout_code(const SceneTuning& tuning, const TuneLayout& layout) {
    return packed_code(tuning.build, tuning.rows[layout.row].setting, layout.layout);
}

std::string hierarchy_code(const BuildOptions& options, const TuneSetting& setting) {
    const std::string build = build_code(options, setting, BuildOptions{}.split);
    std::string code;
    switch (setting.volume) {
#define SCB_TYPE(kind, V, name)                          \
    case VolumeKind::kind:                               \
        code = "scb::build_hierarchy<scb::" #V ">(mesh"; \
        break;
        SCB_FOR_EACH_VOLUME_KIND(SCB_TYPE)
#undef SCB_TYPE
    }
    return code + (build.empty() ? "" : ", " + build) + ")";
}

std::string setting_code(const SceneTuning& tuning, const TuneSetting& setting) {
    const std::string code = hierarchy_code(tuning.build, setting);
    std::string options;
    const OverlapOptions& overlap = setting.overlap;
    if (setting.volume == VolumeKind::scb && overlap.test != OverlapOptions{}.test)
        options = ".overlap = {scb::OverlapTest::" + std::string(overlap_test_name(overlap.test)) +
                  (has_threshold(overlap.test) ? ", " + Json(overlap.threshold).dump() : "") + "}";
    if (setting.descent != CollideOptions{}.descent)
        options += (options.empty() ? ".descent = scb::DescentRule::"
                                    : ", .descent = scb::DescentRule::") +
                   std::string(descent_rule_name(setting.descent));
    return options.empty() ? code : code + "; scb::collide(a, b, b_to_a, {" + options + "})";
}

std::string use_text(const SceneTuning& tuning, const std::string& command,
                     const std::string& layout_command) {
    if (layout_command.empty())
        return "To use it: " + command +
               "\n  in C++: " + setting_code(tuning, tuning.rows[tuning.recommended()].setting) +
               "\n";
    const std::string code = layout_code(tuning, tuning.layouts[*tuning.quicker_layout]);
    return tuning.timed() ? "To use it: " + command + "\nQuicker, packed: " + layout_command +
                                "\n  in C++: " + code + "\n"
                          : "To use it: " + layout_command + "\n  in C++: " + code +
                                "\nUnpacked: " + command + "\n";
}

std::string layout_sentence(const SceneTuning& tuning) {
    if (!tuning.no_layouts.empty()) return tuning.no_layouts;
    if (!tuning.timed() || tuning.layouts.empty()) return "";
    const std::string unpacked = setting_text(tuning.rows[tuning.least_time].setting);
    if (!tuning.quicker_layout)
        return std::string("No packed layout is ") + (tuning.runs == 1 ? "" : "measurably ") +
               "quicker than " + unpacked + ".";
    const TuneLayout& best = tuning.layouts[*tuning.quicker_layout];
    std::size_t alike = 0;
    for (const TuneLayout& other : tuning.layouts) alike += !apart(*other.ms, *best.ms);
    return "Best packed: " + layout_text(tuning, best) +
           format(", %.2f of that of ",
                  ratio(best.ms->median, tuning.rows[tuning.least_time].ms->median, 1)) +
           unpacked +
           (tuning.runs == 1 ? std::string("; one run")
            : alike > 1
                ? format("; of %zu layouts between which no difference was measured the one "
                         "with the least memory",
                         alike)
                : std::string()) +
           ".";
}

std::string layout_rows_text(const SceneTuning& tuning, std::size_t most) {
    std::string text;
    std::vector<const TuneLayout*> of_row;
    for (std::size_t i = 0; i < tuning.layouts.size(); ++i) {
        const TuneLayout& layout = tuning.layouts[i];
        of_row.push_back(&layout);
        if (i + 1 < tuning.layouts.size() && tuning.layouts[i + 1].row == layout.row) continue;
        text += "\n" + packed_text(tuning.rows[layout.row].setting) +
                ", packed: N_v and N_p over those unpacked\n"
                "  layout      leaf         N_v /unpacked         N_p /unpacked    cost   B/tri" +
                (!tuning.timed()    ? ""
                 : tuning.runs == 1 ? "  build ms  ms, one run"
                                    : "  build ms      ms [least, most]") +
                "\n";
        if (tuning.timed()) {
            std::stable_sort(of_row.begin(), of_row.end(),
                             [](const TuneLayout* x, const TuneLayout* y) {
                                 return x->ms->median < y->ms->median;
                             });
            of_row.resize(std::min(of_row.size(), most));
        }
        for (const TuneLayout* each : of_row) text += row_text(tuning, *each);
        of_row.clear();
    }
    const std::string sentence = layout_sentence(tuning);
    return text + (sentence.empty() ? "" : "\n" + sentence + "\n");
}

Json layouts_json(const SceneTuning& tuning) {
    Json list = Json::array();
    for (const TuneLayout& layout : tuning.layouts) {
        const TuneSetting& setting = tuning.rows[layout.row].setting;
        Json entry = {{"setting", layout.row},
                      {"volume", volume_kind_name(setting.volume)},
                      {"split", split_method_name(setting.split)},
                      {"growth", ball_growth_name(setting.growth)},
                      {"layout", packed_layout_name(layout.layout)},
                      {"leaf", layout.layout.leaf_triangles},
                      {"n_v", tuning.mean(layout.n_v)},
                      {"n_p", tuning.mean(layout.n_p)},
                      {"n_exact", tuning.mean(layout.n_exact)},
                      {"n_after_doubles", tuning.mean(layout.n_after_doubles)},
                      {"pairs", tuning.mean(layout.pairs)},
                      {"misses_pairs", layout.misses_pairs},
                      {"bytes_per_triangle", layout.bytes_per_triangle}};
        if (layout.picoseconds > 0) entry["cost"] = tuning.mean(layout.picoseconds) / 1000;
        if (layout.ms)
            entry.update(Json{{"build_ms", layout.build_ms},
                              {"ms", layout.ms->median},
                              {"ms_least", layout.ms->low},
                              {"ms_most", layout.ms->high}});
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace scb::app
