#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/choice.h"
#include "app/cli/commands.h"
#include "app/cli/validators.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/query_comparison.h"
#include "app/pictures/query_index.h"
#include "app/query/level_list.h"
#include "core/analysis/trace_diff.h"
#include "core/analysis/trace_prefix.h"
#include "core/base/text_format.h"
#include "render/figures/pairs_figure.h"
#include "render/figures/rejections_figure.h"
#include "render/figures/stages_figure.h"
#include "scb/error.h"
#include "scenes/text/number_list.h"

namespace scb::app {
namespace {

struct RejectionsOptions : QueryViewOptions {
    render::NodeColor by = render::NodeColor::dominant;
    std::string stages, depths, body;
    double opacity = 1;
    bool nested = false;
    std::optional<double> focus;
    std::optional<std::int64_t> steps;
};

/// Of the ended paths, unless told otherwise: without the volumes at which the others ended, most
/// of a CAD model can be seen.
constexpr double default_focus = 0.5;
/// See QueryViewOptions::held_part.
constexpr double held_in_focus = 0.15;

std::string names_of(const TraceHeader& header, const std::vector<Outcome>& endings) {
    std::string names;
    for (const Outcome ending : endings)
        names += (names.empty() ? "" : ", ") + ending_words(header, ending);
    return names;
}

/// Roots that are leaves are a single test too.
bool rejects_roots(const TraceFrame& frame) {
    return frame.found.n_v == 1 && frame.found.n_p == 0 && frame.found.pairs.empty();
}

/// "7" or "0:9".
std::pair<int, int> depth_range(const std::string& text, int deepest_level) {
    const std::string option = "--depth " + text;
    const std::string hint = "; give a level such as 7, or the first and the last such as 0:9.";
    const std::vector<std::string> parts = scenes::split_list(text, ':');
    if (parts.size() > 2) throw InputError(option + ": these are not two levels" + hint);
    const int first = scenes::whole_number(parts.front(), option, hint),
              last = scenes::whole_number(parts.back(), option, hint);
    if (first < 0 || last < first || last > deepest_level)
        throw InputError(option + ": this scene's hierarchies have the levels 0 to " +
                         std::to_string(deepest_level) + hint);
    return {first, last};
}

int deepest_level(const QuerySource& source) {
    const int frame = source.frames().front();
    return std::max(depth(source.body(0, frame).tree->shape()),
                    depth(source.body(1, frame).tree->shape()));
}

render::RejectionsStyle style_of(const RejectionsOptions& options, const QuerySources& sources) {
    const QuerySource& source = sources.front();
    render::RejectionsStyle style;
    style.by = options.by;
    std::vector<Outcome> known;
    for (const QuerySource& each : sources)
        for (const Outcome ending : endings_of(each.header()))
            if (std::find(known.begin(), known.end(), ending) == known.end())
                known.push_back(ending);
    if (!options.stages.empty())
        for (const std::string& name : scenes::split_list(options.stages)) {
            std::optional<Outcome> ending;
            for (const QuerySource& each : sources)
                if (!ending) ending = ending_of(each.header(), name);
            if (!ending || std::find(known.begin(), known.end(), *ending) == known.end())
                throw InputError("--stages " + options.stages + ": '" + name +
                                 "' is not an ending of these queries; give some of " +
                                 names_of(source.header(), known) + ".");
            style.filter.endings.push_back(*ending);
        }
    if (!options.depths.empty())
        std::tie(style.filter.least_depth, style.filter.most_depth) =
            depth_range(options.depths, deepest_level(source));
    const TraceHeader& header = source.header();
    if (!options.body.empty()) {
        for (std::size_t side = 0; side < 2; ++side)
            style.sides[side] = header.bodies[side].name == options.body;
        // A and B are the first and the second, whatever they are called.
        if (!style.sides[0] && !style.sides[1])
            style.sides = {options.body == "A", options.body == "B"};
        if (!style.sides[0] && !style.sides[1])
            throw InputError("--body " + options.body + ": the bodies are " +
                             header.bodies[0].name + " and " + header.bodies[1].name +
                             "; give one of them.");
    }
    if (!(options.opacity > 0 && options.opacity <= 1))
        throw InputError(format("--opacity %g: give a number above 0 (clear) up to 1 (opaque).",
                                options.opacity));
    style.opacity = options.opacity;
    style.nested = options.nested;
    if (options.focus && !(*options.focus > 0 && *options.focus <= 1))
        throw InputError(format(
            "--focus %g: give a share of the ended paths, above 0 up to 1 (all).", *options.focus));
    // Animations show every test.
    const bool whole = options.steps || options.nested;
    style.focus = options.focus.value_or(whole ? 1 : default_focus);
    style.theme = options.picture.theme();
    return style;
}

/// The subtitle, and which nodes are shown, where not all are.
std::string filtered(std::string text, const RejectionsOptions& options) {
    const auto add = [&text](const std::string& what, const std::string& value) {
        if (!value.empty()) text += (text.empty() ? "only " : ", only ") + what + value;
    };
    add("body ", options.body);
    add("levels ", options.depths);
    add("", options.stages);
    return text;
}

std::string title_of(const RejectionsOptions& options) {
    std::string title = "rejections";
    if (options.by != RejectionsOptions{}.by)
        title += " by " + std::string(render::node_color_names[options.by]);
    return filtered("", options).empty() ? title : title + ", filtered";
}

NamedOptions named(const RejectionsOptions& options) {
    const RejectionsOptions usual;
    NamedOptions named;
    named.add_if(options.by != usual.by, "by", std::string(render::node_color_names[options.by]));
    named.add_if(!options.stages.empty(), "stages", options.stages);
    named.add_if(!options.depths.empty(), "depth", options.depths);
    named.add_if(!options.body.empty(), "body", options.body);
    named.add_if(options.opacity != usual.opacity, "opacity", exact_number(options.opacity));
    named.add_if(options.nested, "nested");
    if (options.focus) named.add("focus", exact_number(*options.focus));
    return named;
}

/// One picture: a query, or its first tests.
struct Shot {
    const QuerySources& sources;
    const QueryView& view;
    const render::RejectionsStyle& style;
    const RejectionsOptions& options;
    PictureRun& pictures;

    /// `step`: how many tests of `whole` the frame has, where it is an animation's.
    void draw(const TraceFrame& frame, const TraversalTree& tree, std::optional<std::size_t> step,
              const TraceFrame& whole) const {
        const QuerySource& source = sources.front();
        const render::QueryBodies bodies = view.bodies(frame.frame);
        const render::EndedNodes ended = render::ended_nodes(bodies, frame, tree, style);
        render::SceneFigure figure;
        figure.title = view.title(title_of(options));
        figure.subtitle = filtered(view.subtitle(frame.frame), options);
        figure.pane = render::rejections_pane(bodies, frame, tree, ended, style);
        const std::vector<render::AnyVolume> region =
            render::contact_region(bodies, source.header(), whole);
        figure.pane.camera = view.camera(region);
        figure.center = view.center(region);
        figure.panel = render::rejections_panel(bodies, source.header(), frame, tree, ended, style);
        view.show_small_contact(figure, region);
        figure.chart = render::endings_chart(source.header(), frame, tree, style);
        figure.theme = style.theme;
        figure.with_panel = !options.picture.no_panel;
        if (step) {
            show_current_pair(figure, bodies, frame, tree, whole.found.n_v);
        } else if (frame.found.n_v == 0) {
            figure.remark = "no tests of volumes were recorded";
        } else if (ended[0].empty() && ended[1].empty()) {
            figure.remark = "no such node";
        } else if (!frame.found.complete) {
            figure.remark = stopped_remark(frame);
        } else if (rejects_roots(frame)) {
            figure.remark = "no overlap: the roots were rejected";
        } else if (frame.found.pairs.empty()) {
            figure.remark = "no contact";
        }
        nlohmann::ordered_json entry = query_index_entry(view, {&frame}, figure.pane.camera);
        entry["volumes"] = {ended[0].size(), ended[1].size()};
        if (step) entry["tests"] = *step;
        const std::string name = view.picture_name("rejections", frame.frame, step);
        pictures.explain(figure);
        const render::Picture picture =
            render::compose(std::move(figure), options.picture.width(), options.picture.height(),
                            options.picture.samples, pictures.overlay());
        pictures.draw(name, picture, std::move(entry));
        view.tell_pick(pictures, name, {&frame});
    }

    void draw_compared(const QueryFrames& frames) const {
        const render::ComparedQueries queries = compared_queries(view, sources, frames);
        const render::PairsOfOne only_here = render::pairs_of_one(queries);
        std::array<render::ComparedView, 2> views =
            render::compared_rejections(queries, only_here, style);
        for (std::size_t i = 0; i < 2; ++i)
            if (render::shows_no_node(views[i].pane))
                views[i].remark = "no such node";
            else if (!frames[i]->found.complete)
                views[i].remark = stopped_remark(*frames[i]);
            else if (rejects_roots(*frames[i]))
                views[i].remark = "no overlap: the roots were rejected";
        draw_comparison(view, queries, only_here, std::move(views), title_of(options), "rejections",
                        options, pictures);
    }

    /// The pair that was tested last, and what its test gave.
    void show_current_pair(render::SceneFigure& figure, const render::QueryBodies& bodies,
                           const TraceFrame& frame, const TraversalTree& tree,
                           std::uint64_t all) const {
        const QuerySource& source = sources.front();
        const std::size_t last = frame.events.volume_tests.size() - 1;
        const TracedTest test = traced_test(source.header(), frame, tree, last);
        for (std::size_t side = 0; side < 2; ++side) {
            const std::uint32_t node = side == 0 ? test.test.nodes.a : test.test.nodes.b;
            if (!bodies[side].tree->has_volume(node)) continue;
            figure.markers.push_back({render::center(render::volume_of(bodies[side], node)),
                                      bodies[side].tree->lengths(node).diameter / 2});
        }
        const std::string result = test.test.stage == Stage::overlapping
                                       ? std::string("overlap")
                                       : "rejected at " + test.stage;
        render::insert_before_notes(
            figure.panel, {"squares: the two nodes of test " + render::count_text(last + 1)});
        figure.remark = "test " + render::count_text(last + 1) + " of " + render::count_text(all) +
                        ": " + result;
    }
};

/// How the paths of each frame ended: a picture for each query.
void draw_stages(std::vector<render::StagesFigure>& stages, const QuerySources& sources,
                 const QueryView& view, const render::RejectionsStyle& style,
                 const RejectionsOptions& options, PictureRun& pictures) {
    double most = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const TraceHeader& header = sources[i].header();
        stages[i].groups = render::shown_groups(header, style);
        for (EndingCounts& counts : stages[i].counts) counts = render::shown_counts(counts, style);
        most = std::max(most, render::most_paths(stages[i]));
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
        render::StagesFigure& figure = stages[i];
        figure.title = view.title("rejections by frame");
        figure.subtitle = view.subtitle();
        std::string name = "rejections_stages";
        if (view.compares()) {
            figure.title += " · " + view.labels()[i].caption;
            name += "_" + view.labels()[i].name;
        }
        figure.theme = options.picture.theme();
        figure.least_top = most;
        const render::Picture picture = render::compose(
            figure, options.picture.width(), options.picture.height(), pictures.overlay());
        pictures.draw(view.picture_name(name), picture, {{"stages", true}}, false);
    }
}

/// How many pictures there will be. An animation's queries are made for it: a sheet is laid out
/// before the first picture is drawn.
std::size_t picture_count(const QuerySource& source, std::optional<std::int64_t> steps) {
    if (!steps) return source.frames().size();
    const auto each = static_cast<std::uint64_t>(*steps);
    std::uint64_t count = 0;
    for (const int frame : source.frames()) count += (source.test_count(frame) + each - 1) / each;
    return count;
}

int run(RejectionsOptions& options, const Console& console) {
    options.check();
    options.named = named(options);
    QuerySources sources = options.open(console);
    const render::RejectionsStyle style = style_of(options, sources);
    // Volumes that are left out need no room.
    if (style.focus < 1) options.held_part = held_in_focus;
    if (options.steps && *options.steps < 1)
        throw InputError("--steps " + std::to_string(*options.steps) + ": give at least 1.");
    if (options.steps && sources.size() == 2)
        throw InputError("--steps: an animation is of one query; leave it out to compare two.");
    std::optional<render::ComparisonLayout> layout;
    if (sources.size() == 2)
        layout = render::comparison_layout(
            options.picture.width(), options.picture.height(),
            render::compared_rejections_rows(sources[0].header(), sources[1].header(), style));
    std::optional<SheetRun> sheet;
    if (options.sheet)
        sheet = options.planned_sheet(picture_count(sources.front(), options.steps), layout);
    PictureRun pictures(options.picture, sources.front().header().scene);
    const QueryView view(options, sources, pictures.renderer(), layout);
    const Shot shot{sources, view, style, options, pictures};
    view.begin_sheet(pictures,
                     options.steps
                         ? format("rejections_steps-%lld", static_cast<long long>(*options.steps))
                         : "rejections",
                     std::move(sheet));
    std::vector<render::StagesFigure> stages(sources.size());
    return draw_frames(
        sources, pictures, console,
        [&](const QueryFrames& frames, const InterruptWatch& watch) {
            for (std::size_t i = 0; i < sources.size(); ++i) {
                stages[i].frames.push_back(frames[i]->frame);
                stages[i].counts.push_back(
                    ending_counts(*frames[i], traversal_tree(sources[i].header(), *frames[i])));
            }
            if (view.compares()) {
                shot.draw_compared(frames);
                return true;
            }
            const QuerySource& source = sources.front();
            const TraceFrame& frame = *frames.front();
            const TraversalTree tree = traversal_tree(source.header(), frame);
            if (!options.steps) {
                shot.draw(frame, tree, std::nullopt, frame);
                return true;
            }
            const std::size_t all = frame.events.volume_tests.size(),
                              each = static_cast<std::size_t>(*options.steps);
            for (std::size_t count = std::min(each, all);; count = std::min(count + each, all)) {
                const TraceFrame part = trace_prefix(source.header(), frame, tree, count);
                shot.draw(part, traversal_tree(source.header(), part), count, frame);
                if (count == all) return true;
                if (watch.signal() != 0) return false;
            }
        },
        [&] {
            if (stages[0].frames.size() > 1 && !options.picture.no_panel)
                draw_stages(stages, sources, view, style, options, pictures);
            nlohmann::ordered_json head = query_index_head(view, "render rejections");
            head["options"]["by"] = render::node_color_names[options.by];
            if (!options.stages.empty())
                head["options"]["stages"] = scenes::split_list(options.stages);
            if (!options.depths.empty())
                head["options"]["depths"] = {style.filter.least_depth, style.filter.most_depth};
            if (!options.body.empty()) head["options"]["body"] = options.body;
            head["options"]["opacity"] = options.opacity;
            head["options"]["nested"] = options.nested;
            head["options"]["focus"] = style.focus;
            if (options.steps) head["options"]["steps"] = *options.steps;
            return head;
        });
}

}  // namespace

void add_render_rejections(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "rejections",
        "Draw the nodes at which a traversal ended, colored by the stage that rejected");
    const auto options = std::make_shared<RejectionsOptions>();
    add_query_view_options(command, *options, Shown::volumes);
    add_choice(command, "--by", options->by, choices_of(render::node_color_names),
               "Color of a node at which several paths ended: its first, last or most frequent "
               "(dominant) ending; or share, the share of its tests that rejected")
        .type_name("WHICH");
    command
        .add_option(
            "--stages,--stage", options->stages,
            "Only paths with these endings: names of stages, 'triangles apart', 'triangles meet'")
        .type_name("LIST");
    command.add_option("--depth", options->depths, "Only nodes of these levels: 7 or 0:9")
        .type_name("A:B");
    command.add_option("--body", options->body, "Only the nodes of this body").type_name("NAME");
    command.add_option("--opacity", options->opacity, "Opacity of the volumes, above 0 to 1")
        .check(real_number)
        .show_default();
    command
        .add_option("--focus", options->focus,
                    "Leave out the volumes that are large for their paths, as long as this share "
                    "of paths is "
                    "seen; 1: none. Default: 0.5, and 1 with --nested or --steps")
        .check(real_number)
        .type_name("SHARE");
    command.add_flag(
        "--nested", options->nested,
        "Also draw nodes that contain other drawn nodes (use --opacity below 1 to see both)");
    command
        .add_option("--steps", options->steps,
                    "Draw an animation: the first N tests, the first 2N, and so on, each with the "
                    "pair that was tested last")
        .check(decimal_number)
        .type_name("N");
    command.footer(
        "Draws each node at which paths of the traversal ended as its exact volume, in front of "
        "the meshes. The counts include\n"
        "all paths, also those that --focus, --depth or --body leave out of the view.\n\n"
        "Examples:\n"
        "  scb render rejections spheres-l1 --frames 100 -o out/\n"
        "  scb render rejections spheres-l1 --frames 100 --body A --stages "
        "slab-cylinder,cylinder-slab "
        "-o out/");
    command.callback([&action, &console, command, options] {
        options->recording = given_recording_options(command);
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
