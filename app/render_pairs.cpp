#include <memory>

#include "app/commands.h"
#include "app/frame_pictures.h"
#include "app/query_view.h"
#include "render/pairs_figure.h"

namespace scb {
namespace {

struct Options : QueryViewOptions {
    bool no_leaves = false;
};

int run(const Options& options, const Console& console) {
    options.check();
    QuerySource source(options.scene, options.hierarchy, options.query, options.limits);
    note_doubts(options.scene, options.query, {source.query().kind}, console);
    PictureRun pictures(options.picture);
    const QueryView view(options, source, pictures.renderer());

    PairsStyle style;
    style.leaves = !options.no_leaves;
    style.theme = options.picture.theme();
    return draw_frames(
        source, pictures, console,
        [&](const TraceFrame& frame) {
            const QueryBodies bodies = view.bodies(frame.frame);
            SceneFigure figure;
            figure.title = view.title("pairs");
            figure.subtitle = view.subtitle(frame.frame);
            figure.pane = pairs_pane(bodies, source.header(), frame, style, view.first_free_id());
            const std::vector<AnyVolume> region = contact_region(bodies, source.header(), frame);
            figure.pane.camera = view.camera(region);
            figure.center = view.center(region);
            figure.panel = pairs_panel(bodies, source.header(), frame, style);
            figure.theme = style.theme;
            if (frame.found.pairs.empty()) figure.remark = "no contact";
            nlohmann::ordered_json entry = view.index_entry(frame, figure.pane.camera);
            // Of the segments, in the order of `scb collide --pairs-out`.
            entry["pair_ids"] = {{"first", view.first_free_id()},
                                 {"count", frame.found.pairs.size()}};
            const Picture picture =
                compose(std::move(figure), options.picture.width(), options.picture.height(),
                        options.picture.samples, pictures.overlay());
            pictures.draw(view.picture_name("pairs", frame.frame), picture, std::move(entry));
        },
        [&] {
            nlohmann::ordered_json head = view.index_head("render pairs");
            head["options"]["leaves"] = style.leaves;
            return head;
        });
}

}  // namespace

void add_render_pairs(CLI::App& render_command, const Console& console, Action& action) {
    CLI::App* command = render_command.add_subcommand(
        "pairs", "The triangles that intersect, and the leaves that overlap");
    const auto options = std::make_shared<Options>();
    add_query_view_options(*command, *options, Shown::meshes);
    command->add_flag("--no-leaves", options->no_leaves,
                      "Without the volumes of leaves that overlap while their triangles do not");
    command->footer(
        "Strong colors are triangles that intersect, black lines where they meet; a line is thin "
        "where a body hides it.\n"
        "Beside the pictures, index.json has their counts, which are `scb collide`'s.\n\n"
        "Examples:\n"
        "  scb render pairs spheres-l1 --frames 100 -o out/\n"
        "  scb render pairs spheres.scbtrace --frames all --camera contact -o out/");
    command->callback([&action, &console, command, options] {
        options->recording = given_recording_options(*command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb
