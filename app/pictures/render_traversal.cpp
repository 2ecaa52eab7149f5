#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/choice.h"
#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/query_index.h"
#include "core/base/enum_names.h"
#include "render/figures/traversal_figure.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// Which of the two diagrams the picture has.
enum class Diagrams { matrix, icicle, both };
constexpr EnumNames<Diagrams, 3> diagram_names = {"matrix", "icicle", "both"};

struct TraversalOptions : QueryViewOptions {
    render::MatrixMeasure by = render::MatrixMeasure::tests;
    Diagrams show = Diagrams::both;
};

int run(TraversalOptions& options, const Console& console) {
    options.check();
    options.named.add_if(options.by != TraversalOptions{}.by, "by",
                         std::string(render::matrix_measure_names[options.by]));
    options.named.add_if(options.show != TraversalOptions{}.show, "show",
                         std::string(diagram_names[options.show]));
    QuerySources sources = options.open(console);
    if (sources.size() == 2)
        throw InputError("a picture of a traversal is of one query; give one trace.");
    PictureRun pictures(options.picture, sources.front().header().scene);
    const QueryView view(options, sources, pictures.renderer());

    render::TraversalFigure figure;
    figure.title = view.title("traversal");
    figure.measure = options.by;
    figure.matrix = options.show != Diagrams::icicle;
    figure.icicle = options.show != Diagrams::matrix;
    figure.theme = options.picture.theme();
    return draw_frames(
        sources, pictures, console,
        [&](const QueryFrames& frames, const InterruptWatch&) {
            const TraceFrame& frame = *frames.front();
            figure.subtitle = view.subtitle(frame.frame);
            const render::Picture picture =
                render::compose(figure, sources.front().header(), frame, options.picture.width(),
                                options.picture.height(), pictures.overlay());
            pictures.draw(view.picture_name("traversal", frame.frame), picture,
                          query_index_entry(view, frames));
            return true;
        },
        [&] {
            nlohmann::ordered_json head = query_index_head(view, "render traversal");
            head["options"]["by"] = render::matrix_measure_names[options.by];
            head["options"]["show"] = diagram_names[options.show];
            return head;
        });
}

}  // namespace

void add_render_traversal(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "traversal", "Draw where a traversal spends its tests, by pairs of nodes");
    const auto options = std::make_shared<TraversalOptions>();
    add_query_view_options(command, *options, Shown::nothing);
    add_choice(command, "--by", options->by, choices_of(render::matrix_measure_names),
               "Colors of the matrix. tests: how many; share: how many of them rejected");
    add_choice(command, "--show", options->show, choices_of(diagram_names),
               "matrix, icicle or both");
    command.footer(
        "Left: the volume tests by depth of A's node and of B's. Right: the recursion as an "
        "icicle, with the roots at the top.\n"
        "Below a pair are its children. The width of a pair is its number of tests: its own and "
        "all that follow from it.\n"
        "Beside the pictures, index.json has their counts, which are those of `scb collide`.\n\n"
        "Examples:\n"
        "  scb render traversal spheres-l1 --frames 250 -o out/\n"
        "  scb render traversal spheres.scbtrace --frames all --by share --show matrix -o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_recording_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
