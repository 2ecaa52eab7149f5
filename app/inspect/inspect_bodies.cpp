#include "app/inspect/inspect_bodies.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/pictures/query_view.h"
#include "core/base/text_format.h"
#include "render/figures/heat_figure.h"

namespace scb::app {
namespace {

constexpr std::size_t most_marked = 3;
/// A square that fills more of the view does not show a place.
constexpr double largest_marked = 0.3;

/// Squares around the smaller node of each of the frame's worst pairs; one square per place.
std::vector<render::SceneMarker> markers_of(const InspectReport& report, int frame,
                                            const render::QueryBodies& bodies) {
    const auto ball_about = [&](std::size_t side, std::uint32_t node) {
        const AnyVolume volume = render::volume_of(bodies[side], node);
        return render::SceneMarker{
            center(volume), std::visit([](const auto& v) { return diameter(v); }, volume) / 2};
    };
    double whole = 0;
    for (std::size_t side = 0; side < 2; ++side)
        for (const std::uint32_t root : bodies[side].tree->shape().roots)
            if (bodies[side].tree->has_volume(root))
                whole = std::max(whole, ball_about(side, root).radius);
    std::vector<FalsePair> worst;
    for (const auto* pairs : {&report.loose_fits, &report.weak_tests})
        for (const FalsePair& pair : *pairs)
            if (pair.frame == frame) worst.push_back(pair);
    std::stable_sort(worst.begin(), worst.end(), [](const FalsePair& x, const FalsePair& y) {
        return x.pair.below.volume_tests > y.pair.below.volume_tests;
    });
    std::vector<render::SceneMarker> markers;
    for (const FalsePair& pair : worst) {
        const render::SceneMarker a = ball_about(0, bodies[0].tree->node_of(pair.test.nodes.a)),
                                  b = ball_about(1, bodies[1].tree->node_of(pair.test.nodes.b));
        const render::SceneMarker& smaller = a.radius <= b.radius ? a : b;
        const bool is_near = std::any_of(markers.begin(), markers.end(), [&](const auto& marked) {
            return std::sqrt(squared_norm(marked.center - smaller.center)) <
                   marked.radius + smaller.radius;
        });
        if (!is_near && smaller.radius <= largest_marked * whole && markers.size() < most_marked)
            markers.push_back(smaller);
    }
    return markers;
}

}  // namespace

std::string draw_bodies(PictureRun& pictures, const PictureOptions& options,
                        const QuerySources& sources, const InspectReport& report) {
    if (report.sum.counts.wasted.volume_tests == 0) return "";
    if (report.header.engine && report.header.engine->objects) return "";
    const int number = report.frames.front().frame;
    const QueryTrace frame = sources.front().frame_again(number);
    QueryViewOptions of_view;
    of_view.picture = options;
    if (report.recording) of_view.scene.names = {report.recording->path};
    const QueryView view(of_view, sources, pictures.renderer());
    const render::QueryBodies bodies = view.bodies(number);
    const render::Heat heat =
        render::heat_of(bodies, report.header, frame, HeatOf::wasted, std::nullopt);
    render::SceneFigure figure;
    figure.title = view.title("where the waste is");
    figure.subtitle = view.subtitle(number);
    figure.pane = render::heat_pane(bodies, heat);
    figure.pane.camera = view.camera({});
    figure.center = view.center({});
    figure.panel = render::heat_panel(bodies, frame, heat);
    figure.markers = markers_of(report, number, bodies);
    if (!figure.markers.empty())
        figure.panel.emplace_back(render::PanelNote{
            figure.markers.size() == 1 ? "square: about a node of a worst pair"
                                       : "squares: about nodes of the worst pairs"});
    figure.theme = options.theme();
    const std::string name = view.picture_name("inspect_bodies", number);
    const render::Picture picture = render::compose(
        std::move(figure), options.width(), options.height(), options.samples, pictures.overlay());
    pictures.draw(name, picture, {{"frame", number}, {"bodies", true}});
    return name + ".png";
}

}  // namespace scb::app
