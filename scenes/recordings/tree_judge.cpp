#include "scenes/recordings/tree_judge.h"

#include <algorithm>

#include "core/judge/mapped_volume.h"

namespace scb::scenes {

void TreeJudge::look(std::uint32_t number, const std::map<std::uint32_t, std::string>& body_names) {
    TreeWatch& watch = watches_[number];
    if (recording_.unfinished_tree() == number) return;
    const EngineSide side = recording_.side_of(number);
    const TreeState& tree = recording_.trees().at(number);
    watch.look(recording_.frame(),
               {*side.tree, *side.shape, side.mesh, recording_.node_tolerance_of(tree),
                tree.version, tree.volume_version});
    const auto mesh = recording_.meshes().find(tree.mesh);
    if (mesh == recording_.meshes().end()) return;
    keep_mesh(tree.mesh, mesh->second);
    find_fit(number, side, mesh->second, recording_.tolerance_of(tree), body_names);
}

/// Keeps meshes of earlier frames, since a tree that was not refitted may belong to one of them.
void TreeJudge::keep_mesh(std::uint32_t number, const MeshState& mesh) {
    constexpr std::size_t most = 8;
    std::deque<EarlierMesh>& kept = earlier_[number];
    if (!kept.empty() && kept.back().version == mesh.version) return;
    kept.push_back({mesh.version, mesh.recorded_at, mesh.finite});
    if (kept.size() > most) kept.pop_front();
}

/// Looks for one change that explains why nodes do not contain what is below them: at the frame
/// with the most such nodes, and in a few frames at most.
void TreeJudge::find_fit(std::uint32_t number, const EngineSide& side, const MeshState& mesh,
                         double tolerance, const std::map<std::uint32_t, std::string>& body_names) {
    const TreeWatch& watch = watches_[number];
    TreeFitting& fitting = fits_[number];
    constexpr int most_tries = 3;
    // A few nodes fit another mesh by chance.
    constexpr std::size_t least_share = 10;
    if (least_share * watch.most_outside() < side.tree->size() || watch.most_outside() == 0 ||
        watch.most_outside_at() != recording_.frame() || fitting.fit ||
        fitting.tries >= most_tries || watch.most_outside() < 2 * fitting.outside)
        return;
    ++fitting.tries;
    fitting.outside = watch.most_outside();
    fitting.frame = recording_.frame();
    std::vector<OtherMesh> others;
    const std::deque<EarlierMesh>& kept = earlier_[recording_.trees().at(number).mesh];
    for (auto earlier = kept.rbegin(); earlier != kept.rend(); ++earlier)
        if (earlier->mesh != mesh.finite)
            others.push_back({"the mesh of frame " + std::to_string(earlier->frame),
                              [of = earlier->mesh] { return *of; }});
    // If a tree has many bodies, some are enough.
    constexpr std::size_t most_bodies = 4;
    std::size_t tried = 0;
    for (const auto& [body_number, body] : recording_.bodies()) {
        if (body.tree != number || !body.placed || !body.pose_fault.empty()) continue;
        if (tried++ == most_bodies) break;
        const auto in_world = [&mesh, stretch = body.stretch](const Pose& pose) {
            Mesh placed = mapped(*mesh.finite, stretch);
            for (Vec3& vertex : placed.vertices) vertex = transform_point(pose, vertex);
            return placed;
        };
        const std::string of = "the pose of " + body_names.at(body_number),
                          world = ", as of volumes in the world";
        others.push_back({of + world, [in_world, pose = body.pose] { return in_world(pose); }});
        if (body.last)
            others.push_back({of + " in the frame before" + world,
                              [in_world, pose = *body.last] { return in_world(pose); }});
    }
    fitting.fit = find_tree_fit(*side.tree, *side.shape, *mesh.finite, tolerance,
                                watch.most_outside(), others);
}

std::vector<TreeJudgement> TreeJudge::judged() {
    std::vector<TreeJudgement> result;
    for (const auto& [number, watch] : watches_) {
        const TreeState& tree = recording_.trees().at(number);
        TreeJudgement judged{number,
                             tree.name,
                             tree.tree.size(),
                             0,
                             0,
                             0,
                             recording_.unfinished_tree() == number,
                             watch.problems(),
                             fits_[number].fit,
                             fits_[number].frame};
        const TreeShape& shape = *recording_.side_of(number).shape;
        for (const std::uint32_t i : shape.order)
            judged.depth = std::max(judged.depth, shape.depths[i]);
        judged.roots = shape.roots.size();
        judged.in_several_leaves = watch.unjudged().of_splits;
        result.push_back(std::move(judged));
    }
    return result;
}

}  // namespace scb::scenes
