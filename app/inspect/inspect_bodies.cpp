#include "app/inspect/inspect_bodies.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/inspect/inspect_pictures.h"
#include "app/pictures/query_view.h"
#include "core/analysis/assumed_time.h"
#include "render/figures/waste_figure.h"

namespace scb::app {
namespace {

/// The triangles of both bodies in the most tests, as the report lists them. Their numbers belong
/// to the first frame; in frame `number` a recorded body may have other triangles.
std::vector<render::MarkedTriangle> marked_triangles(const InspectReport& report,
                                                     const QuerySource& source, int number) {
    const auto by_frame = [](const InspectedFrame& x, const InspectedFrame& y) {
        return x.frame < y.frame;
    };
    const int first = std::min_element(report.frames.begin(), report.frames.end(), by_frame)->frame;
    struct Candidate {
        render::MarkedTriangle triangle;
        std::uint64_t tests;
    };
    std::vector<Candidate> all;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::shared_ptr<const Mesh> listed = source.body(side, first).mesh,
                                          drawn = source.body(side, number).mesh;
        for (const CostlyTriangle& costly : report.triangles[side].costly)
            if (const std::uint32_t t = costly.tests.triangle;
                t < drawn->triangles.size() && drawn->triangles[t] == listed->triangles[t])
                all.push_back({{side, t}, costly.tests.items});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& x, const Candidate& y) { return x.tests > y.tests; });
    all.resize(std::min(all.size(), most_costly));
    std::vector<render::MarkedTriangle> marked;
    for (const Candidate& one : all) marked.push_back(one.triangle);
    return marked;
}

/// Of a query of distances, sets the hits to the tests that led to the answer: a hit is recorded if
/// triangles were the nearest so far.
void mark_nearest(QueryTrace& frame, const Attribution& attribution) {
    std::vector<bool> leads(frame.steps.volumes.size());
    for (const PassedPair& pair : attribution.passed)
        leads[pair.test] = pair.reason == PassReason::triangles_meet;
    for (ItemStep& item : frame.steps.items) item.hit = item.step != no_step && leads[item.step];
}

}  // namespace

std::string draw_bodies(PictureRun& pictures, const PictureOptions& options,
                        const QuerySources& sources, const InspectReport& report) {
    if (report.sum.counts.wasted().volume_tests == 0) return "";
    if (report.header.engine && report.header.engine->objects) return "";
    const int number = report.frames.front().frame;
    QueryTrace frame = sources.front().frame_again(number);
    if (is_of_distance(report.header.kind) && !report.recording)
        mark_nearest(frame, sources.front().attribution(frame));
    QueryViewOptions of_view;
    of_view.picture = options;
    of_view.seeks_contact = false;
    of_view.one_picture = true;
    if (report.recording) of_view.scene.names = {report.recording->path};
    QueryView view(of_view, sources, pictures.renderer());
    const render::QueryBodies bodies = view.bodies(number);
    const render::Waste waste =
        render::waste_of(bodies, report.header, frame, assumed_costs(report.header),
                         marked_triangles(report, sources.front(), number));
    const std::vector<AnyVolume> region = render::waste_region(bodies, waste);
    view.seek(render::waste_subject(bodies, waste), number);
    render::SceneFigure figure;
    figure.title = view.title("where the waste is");
    figure.subtitle = view.subtitle(number);
    figure.theme = options.theme();
    figure.pane = render::waste_pane(bodies, waste, *figure.theme);
    figure.pane.camera = view.camera(region);
    figure.center = view.center(region);
    figure.labels = render::waste_labels(bodies, waste);
    figure.panel = render::waste_panel(bodies, frame, waste, *figure.theme);
    view.show_place_of_contact(figure, region);
    const std::string name =
        view.picture_name(name_of_inspection(report).substr(1) + "_bodies", number);
    const render::Picture picture = render::compose(
        std::move(figure), options.width(), options.height(), options.samples, pictures.overlay());
    pictures.draw(name, picture, {{"frame", number}, {"bodies", true}});
    return name + ".png";
}

}  // namespace scb::app
