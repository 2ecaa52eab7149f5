#include "tests/peers/comparison.h"

#include <algorithm>

#include "core/platform/clock.h"
#include "scb/triangle_overlap.h"
#include "tests/peers/core_mesh.h"
#include "tests/peers/peers.h"

namespace scb {

SceneComparison compare_peers(const scenes::Scene& scene, const std::vector<int>& frames,
                              std::span<const PeerKind> kinds, PeerQuery query,
                              std::size_t compared_frames, const PeerTiming& timing) {
    const auto say = [&](const std::string& what) {
        if (timing.progress) timing.progress(what);
    };
    const scenes::Body &body_a = scene.bodies[0], &body_b = scene.bodies[1];
    const Mesh &mesh_a = scene.meshes[body_a.mesh].mesh, &mesh_b = scene.meshes[body_b.mesh].mesh;
    const PeerMesh a = peer_mesh(mesh_a), b = peer_mesh(mesh_b);

    SceneComparison result;
    result.scene = scene.name;
    result.triangles = mesh_a.triangles.size() + mesh_b.triangles.size();
    result.frames = frames;
    result.peers.resize(kinds.size());
    std::vector<std::unique_ptr<Peer>> peers;
    std::size_t reference = 0;
    for (std::size_t p = 0; p < kinds.size(); ++p) {
        say("builds " + kinds[p].name);
        if (kinds[p].name == reference_name) reference = p;
        const double start = milliseconds(Clock::process);
        peers.push_back(kinds[p].prepare(a, b, query));
        result.peers[p].build_ms = milliseconds(Clock::process) - start;
        result.peers[p].bytes = peers[p]->bytes() / static_cast<double>(result.triangles);
    }

    std::vector<PeerPoses> poses;
    poses.reserve(frames.size());
    for (const int frame : frames)
        poses.push_back({peer_pose(scenes::pose_at(body_a.motion, frame)),
                         peer_pose(scenes::pose_at(body_b.motion, frame))});

    say("compares pairs");
    const Box box = bounding_box(mesh_a);
    const double closeness = closeness_share * (box.upper - box.lower).maxCoeff();
    std::vector<double> estimates(kinds.size());
    const Clock clock = timing.wall ? Clock::wall : Clock::thread;
    const std::size_t step = (frames.size() + compared_frames - 1) / compared_frames;
    for (std::size_t i = 0; i < frames.size(); i += step) {
        const PairScene at{mesh_a, mesh_b,
                           relative_pose(scenes::pose_at(body_a.motion, frames[i]),
                                         scenes::pose_at(body_b.motion, frames[i])),
                           closeness};
        peers[reference]->query(poses[i].a, poses[i].b);
        const std::vector<IndexPair> expected = peers[reference]->pairs();
        for (std::size_t p = 0; p < peers.size(); ++p) {
            const double start = milliseconds(clock);
            peers[p]->query(poses[i].a, poses[i].b);
            estimates[p] += milliseconds(clock) - start;
            std::vector<IndexPair> found = peers[p]->pairs();
            // Each peer may find another first pair. An own peer's pair must intersect.
            if (query == PeerQuery::first_contact && !found.empty() && !expected.empty() &&
                (!kinds[p].own ||
                 triangles_overlap(corners(mesh_a, found[0].a),
                                   transform_corners(at.b_to_a, corners(mesh_b, found[0].b)))))
                found = expected;
            add_frame(result.peers[p].difference, expected, found, at);
        }
    }
    for (std::size_t p = 0; p < peers.size(); ++p)
        estimates[p] /= static_cast<double>(result.peers[p].difference.frames);
    // No peer takes more frames than the one that all are compared with: with frames closer to each
    // other, it would be the warmer.
    for (std::size_t p = 0; p < peers.size(); ++p)
        if (kinds[p].name == baseline_name)
            for (double& estimate : estimates) estimate = std::max(estimate, estimates[p]);

    std::vector<PeerTimes> times = time_peers(peers, estimates, poses, timing);
    for (std::size_t p = 0; p < peers.size(); ++p) result.peers[p].times = std::move(times[p]);
    return result;
}

}  // namespace scb
