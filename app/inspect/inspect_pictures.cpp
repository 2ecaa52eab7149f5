#include "app/inspect/inspect_pictures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/explain/explain_pictures.h"
#include "app/explain/explain_report.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_page.h"
#include "app/timing/tune_report.h"
#include "core/base/text_format.h"
#include "render/figures/inspect_figure.h"
#include "render/figures/volume_titles.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

const std::string loose = "fit too loose";

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
    figure.subtitle = inspect_subtitle(report);
    figure.frames = report.frames;
    figure.sum = report.sum;
    figure.others = report.others;
    if (report.settings) {
        figure.settings_from = report.settings->base().counts;
        figure.settings = best_of_volumes(*report.settings);
        figure.best = setting_text(report.settings->rows[report.settings->recommended()].setting);
    }
    figure.theme = options.theme();
    const render::Picture picture =
        render::compose(figure, options.width(), options.height(), pictures.overlay());
    pictures.draw(inspect_name(report), picture, Json{{"summary", true}});
}

void draw_pair(PictureRun& pictures, const PictureOptions& options, const SceneQuery& query,
               const InspectReport& report, int frame, const Step& test, const std::string& reason,
               const std::string& detail) {
    const ExplainedPair pair =
        explained_nodes(query, frame, {test.nodes.a, test.nodes.b}, "the report");
    const std::string file = file_of(report, frame, test);
    ExplainPicture picture;
    picture.name = file.substr(0, file.size() - std::string_view(".png").size());
    const PairNames names = pair_names(query.scene.name, pair);
    picture.title = reason + " · " + names.nodes;
    const std::string asked = asked_words(pair);
    picture.subtitle = format("frame %d, ", frame) + detail + (asked.empty() ? "" : ", " + asked) +
                       " · " + (names.scene.empty() ? "" : names.scene + " · ") +
                       std::string(render::volume_title(query.kind));
    if (reason == loose) picture.but = "the fit is too loose";
    place_nodes(picture, query, frame, pair);
    draw_explanation(pictures, options, pair, picture,
                     Json{{"frame", frame}, {"nodes", {test.nodes.a, test.nodes.b}}});
}

}  // namespace

std::string inspect_name(const InspectReport& report, const NamedOptions& more) {
    return picture_name(report.stem,
                        std::string(volume_kind_name(report.header.volume)) + "_inspect",
                        report.named + report.named_frames + more, "");
}

bool draw_inspection(PictureRun& pictures, const PictureOptions& options, const SceneQuery& query,
                     const InspectReport& report, const std::function<bool()>& step) {
    draw_summary(pictures, options, report);
    if (!step()) return false;
    for (const WronglyRejectedPair& w : report.wrong) {
        draw_pair(pictures, options, query, report, w.frame, w.test, "REJECTED WRONGLY",
                  missed_words(w.rejection));
        if (!step()) return false;
    }
    for (const auto* worst : {&report.loose_fits, &report.weak_tests})
        for (const FalsePair& p : *worst) {
            const std::uint64_t wasted = p.pair.below.volume_tests;
            draw_pair(pictures, options, query, report, p.frame, p.test,
                      worst == &report.loose_fits ? loose : "test too weak",
                      render::count_text(wasted) +
                          (wasted == 1 ? " volume test wasted" : " volume tests wasted"));
            if (!step()) return false;
        }
    return true;
}

}  // namespace scb::app
