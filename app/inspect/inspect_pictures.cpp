#include "app/inspect/inspect_pictures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/explain/explain_pictures.h"
#include "app/explain/explain_report.h"
#include "app/inspect/inspect_findings.h"
#include "app/inspect/inspect_page.h"
#include "core/base/text_format.h"
#include "render/figures/inspect_figure.h"
#include "render/figures/volume_titles.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

const std::string loose = "fit too loose";

/// So many have room in the panel.
constexpr std::size_t most_volumes = 4;

/// The best split of each volume, all else as in the base, so that volumes can be compared; the
/// best first.
std::vector<render::InspectedSetting> best_of_volumes(const SceneTuning& tuning) {
    std::vector<render::InspectedSetting> settings;
    for (std::size_t r = 1; r < tuning.rows.size(); ++r) {
        const TuneRow& row = tuning.rows[r];
        TuneSetting as_base = tuning.base().setting;
        as_base.volume = row.setting.volume;
        as_base.split = row.setting.split;
        if (row.misses_pairs || !(row.setting == as_base)) continue;
        const std::string name(volume_kind_name(row.setting.volume));
        const auto same = std::find_if(settings.begin(), settings.end(),
                                       [&](const auto& s) { return s.name == name; });
        if (same == settings.end())
            settings.push_back({name, row.counts});
        else if (estimated_cost(row.counts) < estimated_cost(same->counts))
            same->counts = row.counts;
    }
    std::stable_sort(settings.begin(), settings.end(), [](const auto& x, const auto& y) {
        return estimated_cost(x.counts) < estimated_cost(y.counts);
    });
    settings.resize(std::min(settings.size(), most_volumes));
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
    }
    figure.theme = options.theme();
    const render::Picture picture =
        render::compose(figure, options.width(), options.height(), pictures.overlay());
    pictures.draw(inspect_name(report), picture, Json{{"summary", true}});
}

void draw_pair(PictureRun& pictures, const PictureOptions& options, const SceneQuery& query,
               const InspectReport& report, int frame, const VolumeTest& test,
               const std::string& reason, const std::string& detail) {
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
    return picture_name(report.header.scene,
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
