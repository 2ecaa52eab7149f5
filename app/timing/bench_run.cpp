#include "app/timing/bench_run.h"

#include <algorithm>

#include "render/figures/volume_titles.h"
#include "scb/error.h"

namespace scb::app {

std::string BenchSubject::title() const {
    if (layout)
        return std::string(render::volume_title(kind)) + " " + packed_layout_name(*layout) +
               (coherent ? " front" : "");
    if (kind != VolumeKind::scb) return std::string(render::volume_title(kind));
    return std::string(render::volume_title(kind)) + " " + std::string(overlap_test_name(test));
}

double SubjectBench::mean_ms() const { return mean(ms); }

std::optional<SceneBench> bench_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const BenchOptions& options,
                                      const std::function<bool()>& step) {
    const std::vector<MeshTopology> topologies =
        scenes::build_topologies(scene, options.build.topology());
    std::vector<VolumeKind> kinds;
    std::vector<std::vector<AnyHierarchy>> hierarchies;  // per kind, per mesh
    std::vector<std::size_t> kind_of;                    // per subject: index of `kinds`
    for (const BenchSubject& subject : options.subjects) {
        const auto known = std::find(kinds.begin(), kinds.end(), subject.kind);
        kind_of.push_back(static_cast<std::size_t>(known - kinds.begin()));
        if (known != kinds.end()) continue;
        kinds.push_back(subject.kind);
        hierarchies.push_back(scenes::fit_meshes(topologies, subject.kind, options.build));
    }

    const std::size_t mesh_a = scene.bodies[a].mesh, mesh_b = scene.bodies[b].mesh;
    std::vector<Pose> poses;
    for (const int frame : frames)
        poses.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                      scenes::pose_at(scene.bodies[b].motion, frame)));
    // Per subject: both bodies, where it is packed.
    std::vector<std::vector<AnyPacked>> packed(options.subjects.size());
    PackedWorkspace workspace;
    std::vector<PackedFront> fronts(options.subjects.size());
    const auto packed_query = [&](std::size_t s, std::size_t i) {
        PackedOptions packed_options = options.packed;
        packed_options.give_up_after = options.max_pairs;
        return collision_of(collide_packed(packed[s][0], scene.meshes[mesh_a].mesh, packed[s][1],
                                           scene.meshes[mesh_b].mesh, poses[i], packed_options,
                                           &workspace,
                                           options.subjects[s].coherent ? &fronts[s] : nullptr));
    };
    const auto any_query = [&](std::size_t s, std::size_t i) {
        if (!packed[s].empty()) return packed_query(s, i);
        CollideOptions collide_options = options.collide;
        collide_options.overlap.test = options.subjects[s].test;
        collide_options.max_pairs = options.max_pairs + 1;
        const std::vector<AnyHierarchy>& h = hierarchies[kind_of[s]];
        return collide(h[mesh_a], scene.meshes[mesh_a].mesh, h[mesh_b], scene.meshes[mesh_b].mesh,
                       poses[i], collide_options);
    };
    const auto query = [&](std::size_t s, std::size_t i) {
        Collision found = any_query(s, i);
        if (!found.complete || found.pairs.size() > options.max_pairs)
            throw InputError(scene.name + ", frame " + std::to_string(frames[i]) + ": more than " +
                             std::to_string(options.max_pairs) +
                             " pairs of triangles intersect; time other meshes or poses.");
        return found;
    };

    SceneBench result;
    result.scene = scene.name;
    result.bodies = {scene.bodies[a].name, scene.bodies[b].name};
    result.frames = frames;
    result.all_frames = frames.size() == static_cast<std::size_t>(scene.frames);
    for (const std::size_t m : {mesh_a, mesh_b})
        result.triangles.push_back(scene.meshes[m].mesh.triangles.size());
    for (std::size_t s = 0; s < options.subjects.size(); ++s) {
        const BenchSubject& subject = options.subjects[s];
        result.subjects.push_back({.subject = subject});
        const std::vector<AnyHierarchy>& h = hierarchies[kind_of[s]];
        std::size_t bytes = 0;
        for (const std::size_t m : {mesh_a, mesh_b}) {
            if (!subject.layout) {
                bytes += bytes_of(h[m]);
                continue;
            }
            packed[s].push_back(pack_any(*subject.layout, h[m], scene.meshes[m].mesh,
                                         scene.name + ", " + scene.meshes[m].name,
                                         options.build.threads));
            bytes += bytes_of(packed[s].back());
        }
        result.subjects[s].bytes_per_triangle =
            static_cast<double>(bytes) /
            static_cast<double>(result.triangles[0] + result.triangles[1]);
    }
    for (std::size_t s = 0; s < options.subjects.size(); ++s) query(s, 0);

    QueryTiming timing;
    timing.subjects = options.subjects.size();
    timing.frames = frames.size();
    timing.repeats = options.repeats;
    timing.order = options.order;
    timing.wall = options.packed.threads > 1;
    timing.query = query;
    // Each time through the frames as if it were the first.
    timing.before = [&](std::size_t s, std::size_t i) {
        if (i == 0) fronts[s].clear();
    };
    timing.keep = [&](std::size_t s, std::size_t, const Collision& found) {
        SubjectBench& subject = result.subjects[s];
        subject.n_v.push_back(found.n_v);
        subject.n_p.push_back(found.n_p);
        subject.n_u.push_back(found.n_u);
        subject.pairs.push_back(found.pairs.size());
        subject.pairs_hash = pairs_hash(found.pairs, subject.pairs_hash);
    };
    timing.step = step;
    const auto ms = time_queries(timing);
    if (!ms) return std::nullopt;
    for (std::size_t s = 0; s < ms->size(); ++s) {
        result.subjects[s].ms = (*ms)[s];
        result.subjects[s].from_front = static_cast<double>(fronts[s].used() - fronts[s].made()) /
                                        static_cast<double>(frames.size());
    }
    return result;
}

}  // namespace scb::app
