#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/heat_options.h"
#include "app/pictures/pairs_figure.h"
#include "app/pictures/query_comparison.h"
#include "app/pictures/query_index.h"
#include "app/query/query_options.h"
#include "scb/error.h"

namespace scb::app {
namespace {

struct PairsOptions : QueryViewOptions {
    bool leaves = false, patches = false;
    HeatOptions heat;
};

render::SceneFigure heat_at_contact(const QueryView& view, const QuerySource& source,
                                    const QueryTrace& frame, const render::QueryBodies& bodies,
                                    const HeatOptions& options) {
    render::SceneFigure figure = heat_figure(view, source, frame, options);
    const TraceHeader& header = source.header();
    look_at_contact(figure, view, frame,
                    render::contact_region(bodies, header, frame,
                                           render::contact_segments(bodies, header, frame)));
    return figure;
}

render::ComparisonLayout layout_of(const PairsOptions& options) {
    return render::comparison_layout(options.picture.width(), options.picture.height(),
                                     !options.heat.of
                                         ? render::compared_pairs_rows({.leaves = options.leaves})
                                         : render::compared_heat_rows());
}

void draw_compared(const QueryView& view, const QuerySources& sources, const QueryFrames& frames,
                   const PairsOptions& options, const render::PairsStyle& style,
                   const std::string& what, PictureRun& pictures) {
    const render::ComparedQueries queries = compared_queries(view, sources, frames);
    const render::PairsOfOne only_here = render::pairs_of_one(queries);
    const bool heat = options.heat.of.has_value();
    std::array<render::ComparedView, 2> views =
        heat ? render::compared_heat(queries, only_here, *options.heat.of, options.heat.scale_end(),
                                     *style.theme)
             : render::compared_pairs(queries, only_here, style, view.ids().first_free);
    for (std::size_t i = 0; i < 2; ++i) {
        std::string remark;
        if (!heat && frames[i]->found.pairs.empty())
            remark = "no contact";
        else if (!frames[i]->found.complete)
            remark = stopped_remark(*frames[i]);
        if (!remark.empty() && !views[i].remark.empty()) remark += ", ";
        views[i].remark = remark + views[i].remark;
    }
    draw_comparison(view, queries, only_here, std::move(views),
                    heat ? options.heat.title() : pairs_title(style), what, options, pictures);
}

int run(PairsOptions& options, const Console& console) {
    options.check();
    options.heat.check();
    const bool heat = options.heat.of.has_value();
    if (options.leaves && heat)
        throw InputError("--leaves: a heat picture has no leaves; leave out --leaves, or --heat.");
    if (options.patches && (heat || options.leaves || !options.compare.empty()))
        throw InputError(
            "--patches: it numbers the pairs of one query; leave out --heat, --leaves and "
            "--compare.");
    if (options.patches && !options.limits.levels.empty())
        throw InputError(
            "--patches: at a level, pairs are of nodes, and patches are of triangles; leave out "
            "--levels.");
    options.named.add_if(options.leaves, "leaves");
    options.named.add_if(options.patches, "patches");
    if (options.leaves) options.shown = Shown::leaves;
    if (heat && options.heat.end) options.named.add("heat-end", std::to_string(*options.heat.end));
    QuerySources sources = options.open(console);
    for (const QuerySource& source : sources)
        if ((heat || options.patches) && source.header().engine && source.header().engine->objects)
            throw InputError(std::string(heat ? "--heat" : "--patches") + ": the items of " +
                             source.header().source.front() +
                             " are objects without triangles; leave it out.");
    for (const QuerySource& source : sources) source.refuse_distances();
    std::optional<render::ComparisonLayout> layout;
    if (sources.size() == 2) layout = layout_of(options);
    std::optional<SheetRun> sheet = options.planned_sheet(sources.front().frames().size(), layout);
    PictureRun pictures(options.picture, sources.front().header().scene);
    const QueryView view(options, sources, pictures.renderer(), layout);

    render::PairsStyle style;
    style.leaves = options.leaves;
    style.patches = options.patches;
    style.theme = options.picture.theme();
    const std::string what = heat ? options.heat.name() : "pairs";
    view.begin_sheet(pictures, what, std::move(sheet));
    return draw_frames(
        sources, pictures, console,
        [&](const QueryFrames& frames) {
            if (view.compares()) {
                draw_compared(view, sources, frames, options, style, what, pictures);
                return nlohmann::ordered_json();
            }
            const QueryTrace& frame = *frames[0];
            const QuerySource& source = sources[0];
            const render::QueryBodies bodies = view.bodies(frame.frame);
            render::SceneFigure figure =
                heat ? heat_at_contact(view, source, frame, bodies, options.heat)
                     : pairs_figure(view, source, frame, bodies, style);
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
            nlohmann::ordered_json head = query_index_head(view, "render pairs");
            if (options.patches) head["options"]["patches"] = true;
            if (heat)
                head["options"]["heat"] = render::heat_names[*options.heat.of];
            else
                head["options"]["leaves"] = style.leaves;
            return head;
        });
}

}  // namespace

void add_render_pairs(const Command& render_command, const Console& console, Action& action) {
    const Command command =
        render_command.add_subcommand("pairs", "Draw the triangles that intersect");
    const auto options = std::make_shared<PairsOptions>();
    add_query_view_options(command, *options, Shown::meshes);
    command
        .add_flag("--leaves,!--no-leaves", options->leaves,
                  "Also draw the volumes of leaves that overlap although their triangles do not")
        .shareable();
    command
        .add_flag("--patches,!--no-patches", options->patches,
                  "Number the contact patches, which are connected sets of pairs: the largest is 1")
        .shareable();
    add_heat_options(command, options->heat, "pair");
    command.footer(
        "Strong colors are triangles that intersect, black lines where they meet, and green areas "
        "where they lie on each other. Triangles are pale and lines dashed where a body hides "
        "them.\n"
        "Without --camera, and if the scene has no camera, the view is from where most of the "
        "contact is visible; index.json has the view.\n"
        "A small contact is shown closely, unless --camera is given or the scene's camera has a "
        "distance.\n"
        "Beside the pictures, index.json has their counts, which are `scb collide`'s.\n\n"
        "Examples:\n"
        "  scb render pairs spheres-l1 --frames 100 -o out/\n"
        "  scb render pairs horses --frames 100 --patches -o out/\n"
        "  scb render pairs spheres.scbrec --frames all --camera contact -o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_recording_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
