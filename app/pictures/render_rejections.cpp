#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/pictures/frame_pictures.h"
#include "app/pictures/query_comparison.h"
#include "app/pictures/query_index.h"
#include "app/pictures/rejections_options.h"
#include "app/query/query_options.h"
#include "core/analysis/trace_diff.h"
#include "core/analysis/trace_prefix.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "render/figures/pairs_figure.h"
#include "render/figures/rejections_figure.h"
#include "render/figures/stages_figure.h"
#include "scb/error.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

/// See QueryViewOptions::held_part.
constexpr double held_in_focus = 0.15;

/// Roots that are leaves also need only one test.
bool rejects_roots(const QueryTrace& frame) {
    return frame.found.n_v == 1 && frame.found.n_p == 0 && frame.found.pairs.empty();
}

/// One picture: a query, or its first tests.
struct Shot {
    const QuerySources& sources;
    const QueryView& view;
    const render::RejectionsStyle& style;
    const RejectionsOptions& options;
    PictureRun& pictures;

    /// `step`: in an animation, the number of tests of `whole` in the frame.
    void draw(const QueryTrace& frame, const Outcomes& outcomes, std::optional<std::size_t> step,
              const QueryTrace& whole) const {
        const QuerySource& source = sources.front();
        const render::QueryBodies bodies = view.bodies(frame.frame);
        const render::EndedNodes ended = render::ended_nodes(bodies, frame, outcomes, style);
        render::SceneFigure figure;
        figure.title = view.title(options.title());
        figure.subtitle = options.filtered(view.subtitle(frame.frame));
        // Of an animation, the camera shows the contact of the whole query.
        const std::vector<render::Segment> contact =
            render::contact_segments(bodies, source.header(), whole);
        const std::vector<AnyVolume> region =
            render::contact_region(bodies, source.header(), whole, contact);
        figure.pane = render::rejections_pane(
            bodies, frame, outcomes, ended,
            step ? render::contact_segments(bodies, source.header(), frame) : contact, style);
        figure.pane.camera = view.camera(region);
        figure.center = view.center(region);
        figure.panel =
            render::rejections_panel(bodies, source.header(), frame, outcomes, ended, style);
        view.show_place_of_contact(figure, region);
        figure.chart = render::endings_chart(source.header(), frame, outcomes, style);
        figure.theme = style.theme;
        figure.with_panel = !options.picture.no_panel;
        if (step) {
            show_current_pair(figure, bodies, frame, outcomes, whole.found.n_v);
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
        Json entry = query_index_entry(view, {&frame}, figure.pane.camera);
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

    /// `outcomes`: of each query.
    void draw_whole(const QueryFrames& frames, const std::vector<Outcomes>& outcomes) const {
        if (view.compares()) return draw_compared(frames);
        const QueryTrace& frame = *frames.front();
        draw(frame, outcomes.front(), std::nullopt, frame);
    }

    /// Draws the animation of a query. Returns false if interrupted.
    bool draw_steps(const QueryTrace& frame, const InterruptWatch& watch) const {
        const TraceHeader& header = sources.front().header();
        const Outcomes outcomes = outcomes_of(header, frame);
        const std::size_t all = frame.steps.volumes.size(),
                          each = static_cast<std::size_t>(*options.steps);
        for (std::size_t count = std::min(each, all);; count = std::min(count + each, all)) {
            const auto draw_step = [&] {
                const QueryTrace part = trace_prefix(header, frame, count);
                draw(part, outcomes_of(header, part), count, frame);
                return Json();
            };
            if (!pictures.part(draw_step, take_nothing)) return false;
            if (count == all) return true;
            if (watch.signal() != 0) return false;
        }
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
        draw_comparison(view, queries, only_here, std::move(views), options.title(), "rejections",
                        options, pictures);
    }

    /// The pair that was tested last, and its test's outcome.
    void show_current_pair(render::SceneFigure& figure, const render::QueryBodies& bodies,
                           const QueryTrace& frame, const Outcomes& outcomes,
                           std::uint64_t all) const {
        const QuerySource& source = sources.front();
        const std::size_t last = frame.steps.volumes.size() - 1;
        const TracedTest test = traced_test(source.header(), frame, outcomes, last);
        for (std::size_t side = 0; side < 2; ++side) {
            const IndexPair nodes = frame.steps.volumes[last].nodes;
            const std::uint32_t node = side == 0 ? nodes.a : nodes.b;
            if (!bodies[side].tree->has_volume(node)) continue;
            figure.markers.push_back({center(render::volume_of(bodies[side], node)),
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

/// How the paths of each frame ended: a picture per query.
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

/// The number of pictures. For an animation this makes the queries, since a sheet is laid out
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
    options.named = options.changed();
    QuerySources sources = options.open(console);
    for (const QuerySource& source : sources) source.refuse_distances();
    const render::RejectionsStyle style = options.style(sources);
    // Volumes that are left out need no room in the view.
    if (style.focus < 1) options.held_part = held_in_focus;
    if (options.steps && *options.steps < 1)
        throw InputError("--steps " + std::to_string(*options.steps) + ": give at least 1.");
    if (options.steps && sources.size() == 2)
        throw InputError("--steps: an animation is of one query; leave it out to compare two.");
    if (options.steps && options.picture.names_file())
        options.picture.check_count(picture_count(sources.front(), options.steps),
                                    "leave out --steps");
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
    // How the paths of a frame ended, for the pictures of all frames.
    const auto ending_counts_of = [](int frame, const std::vector<Outcomes>& outcomes) {
        Json kept = {{"frame", frame}, {"counts", Json::array()}};
        for (const Outcomes& of_query : outcomes) kept["counts"].push_back(ending_counts(of_query));
        return kept;
    };
    const auto outcomes_at = [&](const QueryFrames& frames) {
        std::vector<Outcomes> outcomes;
        for (std::size_t i = 0; i < sources.size(); ++i)
            outcomes.push_back(outcomes_of(sources[i].header(), *frames[i]));
        return outcomes;
    };
    const auto take = [&](const Json& kept) {
        for (std::size_t i = 0; i < stages.size(); ++i) {
            stages[i].frames.push_back(kept.at("frame").get<int>());
            stages[i].counts.push_back(kept.at("counts").at(i).get<EndingCounts>());
        }
    };
    const auto head = [&] {
        if (stages[0].frames.size() > 1 && !options.picture.no_panel)
            draw_stages(stages, sources, view, style, options, pictures);
        Json json = query_index_head(view, "render rejections");
        json["options"]["by"] = render::node_color_names[options.by];
        if (!options.stages.empty()) json["options"]["stages"] = split_list(options.stages);
        if (!options.depths.empty())
            json["options"]["depths"] = {style.filter.least_depth, style.filter.most_depth};
        if (!options.body.empty()) json["options"]["body"] = options.body;
        json["options"]["opacity"] = options.opacity;
        json["options"]["nested"] = options.nested;
        json["options"]["focus"] = style.focus;
        if (options.steps) json["options"]["steps"] = *options.steps;
        return json;
    };
    if (!options.steps)
        return draw_frames(
            sources, pictures, console,
            [&](const QueryFrames& frames) {
                const std::vector<Outcomes> outcomes = outcomes_at(frames);
                shot.draw_whole(frames, outcomes);
                return ending_counts_of(frames[0]->frame, outcomes);
            },
            take, head);
    // Each step is a part of the run.
    pictures.plan(picture_count(sources.front(), options.steps),
                  [&] { return subject_of(sources); });
    return make_frames(
        sources, pictures, console,
        [&](int frame, const InterruptWatch& watch) {
            const QueryFrames frames = queries_at(sources, frame);
            take(ending_counts_of(frame, outcomes_at(frames)));
            return shot.draw_steps(*frames.front(), watch);
        },
        head);
}

}  // namespace

void add_render_rejections(const Command& render_command, const Console& console, Action& action) {
    const Command command = render_command.add_subcommand(
        "rejections",
        "Draw the nodes at which a traversal ended, colored by the stage that rejected");
    const auto options = std::make_shared<RejectionsOptions>();
    add_rejections_options(command, *options);
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
        options->animated = options->steps.has_value();
        action = [&console, options] { return run(*options, console); };
    });
}

}  // namespace scb::app
