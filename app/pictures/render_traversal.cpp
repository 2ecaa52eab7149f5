#include <memory>

#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/query_view.h"
#include "render/figures/traversal_figure.h"
#include "scb/error.h"

namespace scb::app {
namespace {

struct Options : QueryViewOptions {
    std::string by = "tests";
    std::string show = "both";

    render::MatrixMeasure measure() const {
        if (by == "tests") return render::MatrixMeasure::tests;
        if (by == "share") return render::MatrixMeasure::share;
        throw InputError("--by " + by + ": give tests or share.");
    }
    void check() {
        QueryViewOptions::check();
        measure();
        if (show != "matrix" && show != "icicle" && show != "both")
            throw InputError("--show " + show + ": give matrix, icicle or both.");
    }
};

int run(Options& options, const Console& console) {
    options.check();
    QuerySources sources = options.open(console);
    if (sources.size() == 2)
        throw InputError("a picture of a traversal is of one query; give one trace.");
    PictureRun pictures(options.picture);
    const QueryView view(options, sources, pictures.renderer());

    render::TraversalFigure figure;
    figure.title = view.title("traversal");
    figure.measure = options.measure();
    figure.matrix = options.show != "icicle";
    figure.icicle = options.show != "matrix";
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
                          view.index_entry(frames));
            return true;
        },
        [&] {
            nlohmann::ordered_json head = view.index_head("render traversal");
            head["options"]["by"] = options.by;
            head["options"]["show"] = options.show;
            return head;
        });
}

}  // namespace

void add_render_traversal(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "traversal", "The traversal itself, by pairs of nodes: where it spends its tests");
    const auto options = std::make_shared<Options>();
    add_query_view_options(command, *options, Shown::nothing);
    command
        .add_option("--by", options->by,
                    "Colors of the matrix: tests (how many) or share (of them rejected)")
        .show_default();
    command.add_option("--show", options->show, "matrix, icicle or both").show_default();
    command.footer(
        "Left, the volume tests by depth of the node of A and that of B. Right, the recursion as "
        "an "
        "icicle: the roots\nat the top, below each pair those that its division led to; a pair is "
        "as wide as the tests that begin with it.\n"
        "Beside the pictures, index.json has their counts, which are `scb collide`'s.\n\n"
        "Examples:\n"
        "  scb render traversal spheres-l1 --frames 250 -o out/\n"
        "  scb render traversal spheres.scbtrace --frames all --by share --show matrix -o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_recording_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
