#include "app/inspect/inspect_pictures.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/explain/explain_pictures.h"
#include "app/explain/explain_report.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_page.h"
#include "app/study/recorded_pair.h"
#include "app/timing/tune_layout_report.h"
#include "app/timing/tune_report.h"
#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "render/figures/figure_words.h"
#include "render/figures/inspect_figure.h"
#include "render/figures/reason_words.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Room in the panel for this many, besides the recommended setting.
constexpr std::size_t most_volumes = 3;

/// The best setting of each volume, the least cost first. The recommended setting is always
/// included, as the only one of its volume.
std::vector<render::InspectedSetting> best_of_volumes(const SceneTuning& tuning) {
    std::vector<render::InspectedSetting> settings;
    const std::size_t recommended = tuning.recommended();
    const VolumeKind best = tuning.rows[recommended].setting.volume;
    std::vector<VolumeKind> seen;
    std::size_t others = 0;
    for (const std::size_t r : tuning.best) {
        const TuneRow& row = tuning.rows[r];
        const VolumeKind kind = row.setting.volume;
        if (r != recommended) {
            if (kind == best || std::find(seen.begin(), seen.end(), kind) != seen.end()) continue;
            seen.push_back(kind);
            // The base is what the others are compared with.
            if (r == 0 || others == most_volumes) continue;
            ++others;
        }
        settings.push_back({std::string(volume_kind_name(kind)), row.counts, r == recommended});
    }
    return settings;
}

void draw_summary(PictureRun& pictures, const PictureOptions& options,
                  const InspectReport& report) {
    render::InspectFigure figure;
    figure.title = inspect_title(report);
    figure.kind = report.header.kind;
    figure.subtitle = inspect_subtitle(report);
    figure.frames = report.frames;
    figure.sum = report.sum;
    figure.others = report.others;
    // The operations of another engine are unknown, so that costs cannot be compared with its.
    if (report.settings && !report.settings->recorded) {
        const SceneTuning& tuning = report.settings->tuning;
        figure.settings_from = tuning.base().counts;
        figure.settings = best_of_volumes(tuning);
        figure.best = setting_text(tuning.rows[tuning.recommended()].setting);
        if (const TuneLayout* const layout = tuning.cheapest_layout()) {
            for (render::InspectedSetting& setting : figure.settings) setting.recommended = false;
            const VolumeKind kind = tuning.rows[layout->row].setting.volume;
            figure.settings.insert(figure.settings.begin(),
                                   {std::string(volume_kind_name(kind)) + ", packed",
                                    {layout->n_v, layout->n_p, 0, layout->picoseconds},
                                    true});
            figure.best = layout_text(tuning, *layout);
        }
    }
    figure.theme = options.theme();
    const render::Picture picture =
        render::compose(figure, options.width(), options.height(), pictures.overlay());
    pictures.draw(inspect_name(report), picture, Json{{"summary", true}});
}

void draw_pair(PictureRun& pictures, const PictureOptions& options, const QuerySource& source,
               const InspectReport& report, const ExplainedPairs& explained, int frame,
               const Step& test, const std::string& reason, const std::string& detail) {
    const ExplainedPair& pair = explained.at({frame, test.nodes.a, test.nodes.b});
    const std::string file = file_of(report, frame, test);
    const TraceHeader& header = report.header;
    ExplainPicture picture;
    picture.name = file.substr(0, file.size() - std::string_view(".png").size());
    const PairNames names = pair_names(source.scene().name, pair);
    picture.title = reason + " · " + names.nodes;
    const std::string asked = header.engine ? "" : asked_words(pair);
    picture.subtitle = format("frame %d, ", frame) + detail + (asked.empty() ? "" : ", " + asked) +
                       " · " + (names.scene.empty() ? "" : names.scene + " · ") +
                       render::volume_title(header);
    if (reason == render::words_of(PassReason::loose_fit, header.kind).title)
        picture.but = "the fit is too loose";
    if (header.engine)
        picture.ending =
            printable(header.engine->name) + ":  " +
            (test.stage == Stage::overlapping ? "passed"
                                              : "rejected at " + stage_words(header, test.stage));
    const std::array<BodyAtFrame, 2> bodies = {source.body(0, frame), source.body(1, frame)};
    place_nodes(picture, bodies,
                {bodies[0].tree->node_of(test.nodes.a), bodies[1].tree->node_of(test.nodes.b)});
    draw_explanation(pictures, options, pair, picture,
                     Json{{"frame", frame}, {"nodes", {test.nodes.a, test.nodes.b}}});
}

}  // namespace

std::string name_of_inspection(const InspectReport& report) {
    return is_of_distance(report.header.kind)
               ? "_inspect_" + std::string(query_kind_name(report.header.kind))
               : "_inspect";
}

std::string inspect_name(const InspectReport& report, const NamedOptions& more) {
    return picture_name(report.stem, volume_file_part(report.header) + name_of_inspection(report),
                        report.named + report.named_frames + more, "");
}

ExplainedPairs explain_pairs(InspectReport& report, const QuerySource& source) {
    ExplainedPairs explained;
    const std::unique_ptr<scenes::RecordedTrace> recorded =
        source.is_recording() ? source.recorded()->rewound() : nullptr;
    std::set<std::tuple<int, std::uint32_t, std::uint32_t>> keys;
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& pair : worst.pairs)
            keys.emplace(pair.frame, pair.test.nodes.a, pair.test.nodes.b);
    for (const WronglyRejectedPair& pair : report.wrong)
        keys.emplace(pair.frame, pair.test.nodes.a, pair.test.nodes.b);
    // Ascending by frame, as recordings are read.
    for (const auto& key : keys) {
        const auto& [frame, a, b] = key;
        explained.emplace(key, recorded
                                   ? recorded_pair(*recorded, frame, {a, b}, "the report").pair
                                   : explained_nodes(source.query(), frame, {a, b}, "the report"));
    }
    for (WorstOfReason& worst : report.worst)
        for (FalsePair& pair : worst.pairs)
            pair.margin = explained.at({pair.frame, pair.test.nodes.a, pair.test.nodes.b})
                              .found.certificate.margin;
    return explained;
}

bool draw_inspection(PictureRun& pictures, const PictureOptions& options, const QuerySource& source,
                     const InspectReport& report, const ExplainedPairs& explained,
                     const std::function<bool()>& step) {
    draw_summary(pictures, options, report);
    if (!step()) return false;
    if (is_of_distance(report.header.kind)) return true;
    for (const WronglyRejectedPair& w : report.wrong) {
        draw_pair(pictures, options, source, report, explained, w.frame, w.test, "REJECTED WRONGLY",
                  missed_words(w.rejection));
        if (!step()) return false;
    }
    for (const WorstOfReason& worst : report.worst)
        for (const FalsePair& p : worst.pairs) {
            const std::uint64_t wasted = p.pair.below.volume_tests;
            draw_pair(pictures, options, source, report, explained, p.frame, p.test,
                      render::words_of(worst.reason, report.header.kind).title,
                      render::count_text(wasted) +
                          (wasted == 1 ? " volume test wasted" : " volume tests wasted"));
            if (!step()) return false;
        }
    return true;
}

}  // namespace scb::app
