#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/heat_options.h"
#include "app/pictures/pairs_figure.h"
#include "app/pictures/query_index.h"
#include "app/query/distance_options.h"
#include "app/query/inside_report.h"
#include "app/query/query_options.h"
#include "render/figures/distance_figure.h"
#include "scb/error.h"
#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/recording_input.h"

namespace scb::app {
namespace {

/// A remark on an answer that has no line; empty if it has lines.
std::string remark_on(const TraceHeader& header, const QueryTrace& frame) {
    if (frame.found.pairs.empty())
        return header.kind == QueryKind::within ? "no triangles are so near"
                                                : "nothing within the limit";
    return frame.nearest && frame.nearest->distance == 0 ? "triangles intersect: the distance is 0"
                                                         : "";
}

struct RenderDistanceOptions : QueryViewOptions {
    HeatOptions heat;
};

/// Bodies in the colors of their numbers of tests, with the lines of the answer.
render::SceneFigure heat_of_distance(const QueryView& view, const QuerySource& source,
                                     const QueryTrace& frame, const HeatOptions& options) {
    const TraceHeader& header = source.header();
    const render::Theme& theme = *view.options().picture.theme();
    const render::QueryBodies bodies = view.bodies(frame.frame);
    render::SceneFigure figure = heat_figure(view, source, frame, options);
    figure.pane.segments = render::contact_segments(bodies, header, frame);
    figure.labels = render::distance_labels(bodies, frame, theme);
    if (!frame.found.pairs.empty())
        figure.panel.push_back(render::distance_key(header, frame, theme));
    if (figure.remark.empty()) figure.remark = remark_on(header, frame);
    look_at_contact(figure, view, frame, {});
    return figure;
}

render::SceneFigure distance_figure(const QueryView& view, const QuerySource& source,
                                    const QueryTrace& frame, InsideReport& inside) {
    const TraceHeader& header = source.header();
    const render::Theme& theme = *view.options().picture.theme();
    const render::QueryBodies bodies = view.bodies(frame.frame);
    const std::vector<render::Segment> lines = render::contact_segments(bodies, header, frame);
    const std::vector<AnyVolume> region = render::contact_region(bodies, header, frame, lines);
    render::SceneFigure figure;
    figure.title = view.title(std::string(query_kind_name(header.kind)));
    render::PairsStyle style;
    style.theme = &theme;
    figure.pane = render::pairs_pane(bodies, header, frame, lines, style, view.ids().first_free);
    figure.panel = render::distance_panel(bodies, header, frame, source.attribution(frame), theme);
    figure.labels = render::distance_labels(bodies, frame, theme);
    figure.remark = remark_on(header, frame);
    if (figure.remark.empty() && frame.nearest)
        figure.remark = inside_words(inside.add(frame.frame));
    look_at_contact(figure, view, frame, region);
    view.show_place_of_contact(figure, region);
    // A magnified line has the room of the chart.
    if (!figure.detail || figure.detail->shows_whole)
        figure.chart = render::distance_chart(header, frame, theme);
    return figure;
}

int run(RenderDistanceOptions& options, const Console& console) {
    for (const std::string& name : options.scene.names) {
        if (scenes::names_trace(name))
            throw InputError(name + ": a trace has the queries that it recorded; give its scene.");
        if (options.scene.names.size() > 1 && scenes::names_recording(name))
            throw InputError(name +
                             ": a recording has both bodies already; give the recording alone.");
    }
    options.check();
    options.heat.check();
    const bool heat = options.heat.of.has_value();
    if (heat && options.heat.end) options.named.add("heat-end", std::to_string(*options.heat.end));
    QuerySources sources = options.open(console);
    std::optional<SheetRun> sheet =
        options.planned_sheet(sources.front().frames().size(), std::nullopt);
    PictureRun pictures(options.picture, sources.front().header().scene);
    const QueryView view(options, sources, pictures.renderer());
    const std::string what =
        heat ? options.heat.name() : std::string(query_kind_name(sources.front().header().kind));
    view.begin_sheet(pictures, what, std::move(sheet));
    InsideReport inside(sources[0].query());
    return draw_frames(
        sources, pictures, console,
        [&](const QueryFrames& frames) {
            const QueryTrace& frame = *frames[0];
            render::SceneFigure figure =
                heat ? heat_of_distance(view, sources[0], frame, options.heat)
                     : distance_figure(view, sources[0], frame, inside);
            nlohmann::ordered_json entry = query_index_entry(view, frames, figure.pane.camera);
            if (!heat) entry["pair_ids"] = pair_ids_json(view, frames)[0];
            pictures.explain(figure);
            const render::Picture picture = render::compose(
                std::move(figure), options.picture.width(), options.picture.height(),
                options.picture.samples, pictures.overlay());
            const std::string name = view.picture_name(what, frame.frame);
            pictures.draw(name, picture, std::move(entry));
            view.tell_pick(pictures, name, frames);
            return nlohmann::ordered_json();
        },
        take_nothing,
        [&] {
            nlohmann::ordered_json head = query_index_head(view, "render distance");
            if (heat) head["options"]["heat"] = render::heat_names[*options.heat.of];
            return head;
        });
}

}  // namespace

void add_render_distance(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "distance", "Draw the closest points of two bodies, and their distance");
    const auto options = std::make_shared<RenderDistanceOptions>();
    set_distance_defaults(options->hierarchy, options->query);
    add_query_view_options(command, *options, Shown::meshes);
    add_heat_options(command, options->heat, "answer");
    command.footer(
        "The black line is the shortest distance, with its number, and dashed where a body hides "
        "it. Strong colors are the closest triangles.\n"
        "With --within, lines are between the closest points of all pairs of triangles that near.\n"
        "The panel counts the pairs of volumes that were left out, by the direction of the largest "
        "bound: the line of the centers, the\n"
        "axes of A or B, or the product of the long axes. Not needed any more: pairs that were "
        "near "
        "enough when they were tested, but\n"
        "not when their turn came. Passed on: pairs that were divided; in vain, if no triangles "
        "below them are as near as the answer.\n"
        "Without --camera or a camera in the scene, the view is from where most of the line is "
        "visible. A short line is shown closely.\n"
        "index.json has the counts of `scb distance`.\n\n"
        "Examples:\n"
        "  scb render distance spheres-l1 --frames 0 -o out/\n"
        "  scb render distance a.ply b.ply --poses log.csv --frames 0:99:10 --sheet -o out/");
    command.callback([&action, &console, options] {
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
