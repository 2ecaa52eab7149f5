#include "app/inspect/recording_pictures.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "app/pictures/picture_name.h"
#include "app/pictures/scene_camera.h"
#include "render/figures/problem_figure.h"
#include "scb/error.h"
#include "scenes/recordings/judgement_words.h"
#include "scenes/recordings/recorded_bodies.h"

namespace scb::app {
namespace {

/// A problem, with the engine's numbers; no_index: none.
struct Problem {
    std::string title, name, what, first;
    std::uint64_t count = 0;
    int frame = 0;
    std::vector<std::string> bodies;
    std::vector<std::uint32_t> nodes, triangles;  ///< of the first body, and of the second
    std::uint32_t tree = no_index;  ///< the tree at fault, if the problem has no bodies
    bool is_worst = false;          ///< the worst fault of a tree, if its faults have amounts
    std::string query{};            ///< the query's own name, as recorded; mostly empty
};

Problem of_group(const scenes::ProblemGroup& group, const std::string& title,
                 const std::string& name) {
    const scenes::ProblemCase& first = group.cases.front();
    return {title,
            name,
            group.what,
            first.words,
            group.count,
            first.query.frame,
            {first.query.a, first.query.b},
            {first.nodes.a, first.nodes.b},
            {first.items.a, first.items.b},
            no_index,
            false,
            first.query.name};
}

/// The title of a problem, with its bodies if the recording has queries of several pairs of bodies,
/// and with the query's name if it has one.
std::string title_of(const Problem& problem, const scenes::Recording& recording) {
    std::string title = problem.title;
    if (recording.pairs.size() > 1 && problem.bodies.size() == 2)
        title += " · " + problem.bodies[0] +
                 (problem.bodies[0] == problem.bodies[1] ? std::string(" against itself")
                                                         : " and " + problem.bodies[1]);
    if (!problem.query.empty()) title += " · \"" + scenes::shown(problem.query) + "\"";
    return title;
}

std::vector<Problem> problems_of(const scenes::RecordingJudgement& judged) {
    std::vector<Problem> problems;
    for (const scenes::TreeJudgement& tree : judged.trees) {
        std::set<TreeFault> seen;
        for (const WatchedProblem& watched : tree.problems) {
            const TreeProblem& p = watched.problem;
            const bool shows = p.node != no_index || p.item != no_index;
            // For a triangle that is not finite, `other` is a vertex, not a node.
            const std::uint32_t other = p.fault == TreeFault::triangle_broken ? no_index : p.other;
            if (!shows || !seen.insert(p.fault).second) continue;
            const auto count = static_cast<std::uint64_t>(std::count_if(
                tree.problems.begin(), tree.problems.end(),
                [&p](const WatchedProblem& each) { return each.problem.fault == p.fault; }));
            problems.push_back({"a fault of the tree",
                                "tree-" + std::to_string(tree.number),
                                scenes::fault_words(p.fault),
                                watched.words,
                                count,
                                watched.worst_at,
                                {},
                                {p.node, other},
                                {p.item},
                                tree.number,
                                p.amount > 0});
        }
    }
    for (const scenes::ProblemGroup& group : judged.test_problems)
        problems.push_back(of_group(group, "a test that went wrong", "test"));
    for (const scenes::ProblemGroup& group : judged.missed)
        problems.push_back(of_group(group, "a missed pair", "missed"));
    for (const scenes::ProblemGroup& group : judged.false_pairs)
        problems.push_back(of_group(group, "a false pair", "false"));
    return problems;
}

/// The bodies of a problem at its frame; for a problem of a tree, the first body with the tree.
std::vector<BodyAtFrame> bodies_of(const Problem& problem, const scenes::RecordedBodies& all) {
    std::vector<BodyAtFrame> bodies;
    if (problem.tree != no_index) {
        for (const BodyAtFrame& body : all.bodies)
            if (body.number == problem.tree && bodies.empty()) bodies.push_back(body);
        return bodies;
    }
    for (const std::string& name : problem.bodies)
        for (const BodyAtFrame& body : all.bodies)
            if (body.name == name) bodies.push_back(body);
    return bodies;
}

/// The node that holds an object; no_index for triangles, which are drawn themselves.
std::uint32_t holder_of(const BodyAtFrame& body, std::uint32_t object) {
    return body.mesh->triangles.empty() ? body.tree->shape().holder_of(object) : no_index;
}

render::ProblemParts parts_of(const Problem& problem, const std::vector<BodyAtFrame>& bodies,
                              render::Renderer& renderer) {
    render::ProblemParts parts;
    std::uint32_t next = 1;
    for (const BodyAtFrame& body : bodies) {
        render::QueryBody& b = parts.bodies.emplace_back();
        b.name = body.name;
        b.mesh = body.mesh.get();
        b.tree = body.tree.get();
        b.handle = renderer.upload(*body.mesh);
        b.pose = body.pose;
        b.first_node_id = next;
        b.first_triangle_id = next + static_cast<std::uint32_t>(body.tree->size());
        next = b.first_triangle_id + static_cast<std::uint32_t>(body.mesh->triangles.size());
    }
    // In a problem of a tree, both nodes are in the same tree.
    const bool one = problem.tree != no_index;
    for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
        const std::size_t body = one ? 0 : i;
        if (body >= bodies.size()) continue;
        const std::uint32_t node = bodies[body].tree->node_of(problem.nodes[i]);
        if (node != no_index && bodies[body].tree->has_volume(node))
            parts.nodes.push_back({body, node});
    }
    for (std::size_t i = 0; i < std::min(problem.triangles.size(), bodies.size()); ++i)
        if (problem.triangles[i] < bodies[i].mesh->triangles.size())
            parts.triangles.push_back({i, problem.triangles[i]});
        else if (const std::uint32_t node = holder_of(bodies[i], problem.triangles[i]);
                 node != no_index && bodies[i].tree->has_volume(node))
            parts.nodes.push_back({i, node});
    return parts;
}

}  // namespace

std::vector<ProblemPicture> draw_problems(PictureRun& pictures, const PictureOptions& options,
                                          const scenes::Recording& recording,
                                          const scenes::RecordingJudgement& judged) {
    const std::vector<Problem> problems = problems_of(judged);
    if (problems.empty()) return {};
    SceneOptions of_file;
    of_file.names = {recording.file->path};
    of_file.selection = recording.file->selection;
    const std::string stem = of_file.file_stem(recording.scene.name);
    NamedOptions named;
    name_picture(named, options);
    std::vector<ProblemPicture> drawn;
    std::optional<scenes::RecordedBodies> at_frame;
    for (const Problem& problem : problems) {
        try {
            if (!at_frame || at_frame->frame != problem.frame)
                at_frame = scenes::bodies_at(recording, problem.frame, scenes::Moment::end);
        } catch (const InputError&) {
            continue;  // for example, a pose is not rigid; the report has the problem as text
        }
        const scenes::RecordedBodies& all = *at_frame;
        const std::vector<BodyAtFrame> bodies = bodies_of(problem, all);
        render::ProblemParts parts = parts_of(problem, bodies, pictures.renderer());
        if (problem.tree != no_index && all.bodies.size() > 1 &&
            problem.tree == all.bodies[1].number && problem.tree != all.bodies[0].number)
            parts.first_side = 1;
        const std::vector<AnyVolume> region = render::problem_region(parts);
        const auto release = [&] {
            for (const render::QueryBody& body : parts.bodies)
                pictures.renderer().release(body.handle);
        };
        if (region.empty()) {
            release();
            continue;
        }
        render::SceneFigure figure;
        figure.title = recording.scene.name + " · " + recording.engine + ", " + all.volumes +
                       " · " + title_of(problem, recording);
        figure.subtitle = "frame " + std::to_string(problem.frame);
        figure.theme = options.theme();
        figure.pane = render::problem_pane(parts, *figure.theme);
        const render::Support support = render::support_of(region);
        figure.pane.camera = camera_for(camera_view_for({}, recording.scene), support,
                                        render::aspect_of(options.layout().view));
        std::vector<render::Support> whole = {support};
        for (const render::QueryBody& body : parts.bodies)
            whole.push_back(render::support_of(*body.mesh, body.pose));
        render::set_depth_range(figure.pane.camera, render::support_of_all(std::move(whole)));
        figure.center = render::center_of(support);
        figure.panel = render::problem_keys(parts, *figure.theme);
        figure.panel.emplace_back(render::PanelHeading{""});
        // For a fault of a tree, the first case is the complete text.
        if (problem.tree == no_index) figure.panel.emplace_back(render::PanelNote{problem.what});
        figure.panel.emplace_back(render::PanelNote{problem.first});
        if (problem.count > 1)
            figure.panel.emplace_back(
                render::PanelNote{(problem.is_worst ? "the worst of " : "the first of ") +
                                  render::count_text(problem.count) + " of the kind"});
        const std::string name =
            picture_name(stem,
                         scenes::file_name_of(recording.engine) + "_problem-" +
                             std::to_string(drawn.size() + 1) + "-" + problem.name,
                         named, frame_part(problem.frame));
        const render::Picture picture =
            render::compose(std::move(figure), options.width(), options.height(), options.samples,
                            pictures.overlay());
        pictures.draw(name, picture,
                      {{"frame", problem.frame}, {"what", problem.what}, {"first", problem.first}});
        drawn.push_back({problem.tree == no_index ? problem.what : problem.first, name + ".png"});
        release();
    }
    return drawn;
}

}  // namespace scb::app
