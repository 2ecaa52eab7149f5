#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/choice.h"
#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/query_index.h"
#include "app/query/distance_options.h"
#include "app/query/query_options.h"
#include "core/analysis/traversal_part.h"
#include "core/base/enum_names.h"
#include "core/platform/number_list.h"
#include "render/figures/traversal_figure.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// The diagrams of the picture.
enum class Diagrams { matrix, icicle, both, bounds };
constexpr EnumNames<Diagrams, 4> diagram_names = {"matrix", "icicle", "both", "bounds"};

struct TraversalOptions : QueryViewOptions {
    render::MatrixMeasure by = render::MatrixMeasure::tests;
    std::optional<Diagrams> show;
    std::string root;
    KindOptions kind{};

    /// Throws InputError.
    Diagrams shown(const TraceHeader& header) const {
        const bool has_bounds = is_of_distance(header.kind) && !header.engine;
        if (show == Diagrams::bounds && !has_bounds)
            throw InputError(
                "--show bounds: queries of overlap have no bounds; add --kind distance.");
        return show.value_or(has_bounds ? Diagrams::bounds : Diagrams::both);
    }
};

/// Number of a query's largest parts in index.json.
constexpr std::size_t most_parts = 8;

std::string pair_text(IndexPair numbers) {
    return std::to_string(numbers.a) + "," + std::to_string(numbers.b);
}

/// The numbers of the nodes of a test: "5,7".
std::string nodes_text(const QueryTrace& frame, std::uint32_t test) {
    return pair_text(numbers_of(frame, frame.steps.volumes[test].nodes));
}

/// "I,J": two numbers.
std::optional<IndexPair> root_of(const TraversalOptions& options) {
    if (options.root.empty()) return std::nullopt;
    const std::string option = "--root " + options.root;
    const std::string hint = "; give the nodes I,J of A and of B, such as 5,7.";
    const std::vector<std::string> parts = split_list(options.root);
    if (parts.size() != 2) throw InputError(option + ": this is not a pair of nodes" + hint);
    const auto node = [&](const std::string& text) {
        const std::int64_t number = large_number(text, option, hint);
        if (number < 0) throw InputError(option + ": nodes are counted from 0" + hint);
        if (number >= no_index) throw InputError(option + ": no node has such a number" + hint);
        return static_cast<std::uint32_t>(number);
    };
    return IndexPair{node(parts[0]), node(parts[1])};
}

std::string parts_text(const QueryTrace& frame, const std::vector<std::uint32_t>& parts) {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(parts.size(), 3); ++i)
        text += (i == 0 ? "" : " or ") + nodes_text(frame, parts[i]);
    return text;
}

/// The part of the frame below the test of these nodes.
QueryTrace part_of(const TraceHeader& header, const QueryTrace& frame, IndexPair root) {
    if (const std::optional<IndexPair> nodes = nodes_of(frame, root))
        if (const std::optional<std::uint32_t> test = test_of(frame.steps, *nodes))
            return traversal_part(header, frame, *test);
    const std::string parts = parts_text(frame, largest_parts(frame.steps, most_parts));
    throw InputError(
        "--root " + pair_text(root) + ": frame " + std::to_string(frame.frame) +
        " has no test of these nodes; " +
        (parts.empty() ? "leave out --root." : "try " + parts + ", its largest parts."));
}

/// The largest parts: their roots and numbers of tests, {"5,7": 1234}.
nlohmann::ordered_json parts_json(const QueryTrace& frame) {
    const std::vector<std::uint32_t> sizes = subtree_sizes(frame.steps);
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const std::uint32_t part : largest_parts(frame.steps, most_parts))
        json[nodes_text(frame, part)] = sizes[part];
    return json;
}

/// Trees of other engines may be lists, too deep for a matrix.
void check_depths(const TraceHeader& header, const QueryTrace& frame) {
    if (!header.engine) return;
    std::size_t deepest = 0;
    for (const Step& test : frame.steps.volumes)
        deepest = std::max<std::size_t>({deepest, test.depth_a, test.depth_b});
    constexpr std::size_t most = 2000;
    if (deepest > most)
        throw InputError("the traversal of frame " + std::to_string(frame.frame) + " is " +
                         std::to_string(deepest) + " levels deep, and a picture has " +
                         std::to_string(most) + "; see it with `scb trace --events`.");
}

int run(TraversalOptions& options, const Console& console) {
    options.check();
    const std::optional<IndexPair> root = root_of(options);
    options.named.add_if(options.by != TraversalOptions{}.by, "by",
                         std::string(render::matrix_measure_names[options.by]));
    QuerySources sources = options.open(console);
    if (sources.size() == 2)
        throw InputError("a picture of a traversal is of one query; give one trace.");
    const TraceHeader& header = sources.front().header();
    const Diagrams shown = options.shown(header);
    const bool is_own_distance = is_of_distance(header.kind) && !header.engine;
    options.named.add_if(is_own_distance, "kind", "distance");
    options.named.add_if(options.show.has_value(), "show", std::string(diagram_names[shown]));
    if (root) options.named.add("root", std::to_string(root->a) + "-" + std::to_string(root->b));
    PictureRun pictures(options.picture, header.scene);
    const QueryView view(options, sources, pictures.renderer());

    render::TraversalFigure figure;
    figure.title = view.title(is_own_distance ? "traversal of a distance" : "traversal");
    figure.measure = options.by;
    figure.matrix = shown == Diagrams::matrix || shown == Diagrams::both;
    figure.icicle = shown == Diagrams::icicle || shown == Diagrams::both;
    figure.theme = options.picture.theme();
    figure.part = root.has_value();
    return draw_frames(
        sources, pictures, console,
        [&](const QueryFrames& frames) {
            const QueryTrace& whole = *frames.front();
            check_depths(header, whole);
            std::optional<QueryTrace> part;
            if (root) part = part_of(header, whole, *root);
            const QueryTrace& frame = root ? *part : whole;
            figure.subtitle = view.subtitle(frame.frame);
            if (root)
                figure.subtitle +=
                    (figure.subtitle.empty() ? "only below nodes " : ", only below nodes ") +
                    pair_text(*root) + ": " +
                    render::share_text(static_cast<double>(frame.found.n_v),
                                       static_cast<double>(whole.found.n_v)) +
                    " of the tests";
            std::optional<DistanceSteps> bounds;
            if (shown == Diagrams::bounds)
                bounds = sources.front().query().distance_steps(header, frame);
            figure.bounds = bounds ? &*bounds : nullptr;
            const render::Picture picture =
                render::compose(figure, header, frame, options.picture.width(),
                                options.picture.height(), pictures.overlay());
            nlohmann::ordered_json entry = query_index_entry(view, {&frame});
            entry["parts"] = parts_json(frame);
            pictures.draw(view.picture_name("traversal", frame.frame), picture, std::move(entry));
            return nlohmann::ordered_json();
        },
        take_nothing,
        [&] {
            nlohmann::ordered_json head = query_index_head(view, "render traversal");
            head["options"]["by"] = render::matrix_measure_names[options.by];
            head["options"]["show"] = diagram_names[shown];
            if (root) head["options"]["root"] = {root->a, root->b};
            return head;
        });
}

}  // namespace

void add_render_traversal(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "traversal", "Draw where a traversal spends its tests, by pairs of nodes");
    const auto options = std::make_shared<TraversalOptions>();
    add_query_view_options(command, *options, Shown::nothing);
    add_kind_options(command, options->kind);
    add_choice(command, "--by", options->by, choices_of(render::matrix_measure_names),
               "Colors of the matrix. tests: how many; share: how many of them rejected")
        .shareable();
    add_choice(command, "--show", options->show, optional_choices(choices_of(diagram_names)),
               "matrix, icicle, both, or, with --kind distance, bounds. Default: both; of "
               "distances: bounds")
        .shareable();
    command
        .add_option("--root", options->root,
                    "Only the part of the traversal below the test of these nodes of A and of B; "
                    "index.json names the largest parts")
        .type_name("I,J")
        .shareable();
    command.footer(
        "Left: the volume tests by depth of A's node and of B's. Right: the recursion as an "
        "icicle, with the roots at the top.\n"
        "Below a pair are its children. The width of a pair is its number of tests: its own and "
        "all that follow from it.\n"
        "Where tests are too narrow, the shares of their outcomes are stacked; --root I,J enlarges "
        "a part.\n"
        "Of distances, the bound of each test by depth: the line is the distance. Pairs with a "
        "bound below it had to be divided;\n"
        "pairs above it were divided before the distance was known.\n"
        "Beside the pictures, index.json has their counts, which are those of `scb collide`.\n\n"
        "Examples:\n"
        "  scb render traversal spheres-l1 --frames 250 -o out/\n"
        "  scb render traversal spheres.scbrec --frames all --by share --show matrix -o out/\n"
        "  scb render traversal spheres-l1 --frames 0 --kind distance -o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_recording_options(command);
        take_kind(command, {"--test", "--threshold", "--max-pairs", "--levels"}, options->scene,
                  options->hierarchy, options->query, options->kind);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
