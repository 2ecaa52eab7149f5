#include "app/bench_run.h"

#include <time.h>

#include <algorithm>

#include "render/volume_titles.h"

namespace scb {
namespace {

/// Processor time of this thread: other programs' turns on a shared machine do not count.
double thread_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

std::string BenchSubject::title() const {
    if (kind != VolumeKind::scb) return std::string(volume_title(kind));
    return std::string(volume_title(kind)) + " " + std::string(overlap_test_name(test));
}

double SubjectBench::mean_ms() const { return mean(ms); }

std::optional<SceneBench> bench_scene(const Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const BenchOptions& options,
                                      const std::function<bool()>& step) {
    const std::vector<MeshTopology> topologies = build_topologies(scene);
    std::vector<VolumeKind> kinds;
    std::vector<std::vector<AnyHierarchy>> hierarchies;  // per kind, per mesh
    std::vector<std::size_t> kind_of;                    // per subject: index of `kinds`
    for (const BenchSubject& subject : options.subjects) {
        const auto known = std::find(kinds.begin(), kinds.end(), subject.kind);
        kind_of.push_back(static_cast<std::size_t>(known - kinds.begin()));
        if (known != kinds.end()) continue;
        kinds.push_back(subject.kind);
        hierarchies.push_back(fit_meshes(topologies, subject.kind, options.fit));
    }

    const std::size_t mesh_a = scene.bodies[a].mesh, mesh_b = scene.bodies[b].mesh;
    std::vector<Pose> poses;
    for (const int frame : frames)
        poses.push_back(relative_pose(pose_at(scene.bodies[a].motion, frame),
                                      pose_at(scene.bodies[b].motion, frame)));
    const auto query = [&](std::size_t s, std::size_t i) {
        CollideOptions collide_options = options.collide;
        collide_options.overlap.test = options.subjects[s].test;
        const std::vector<AnyHierarchy>& h = hierarchies[kind_of[s]];
        return collide(h[mesh_a], scene.meshes[mesh_a].mesh, h[mesh_b], scene.meshes[mesh_b].mesh,
                       poses[i], collide_options);
    };

    SceneBench result;
    result.scene = scene.name;
    result.bodies = {scene.bodies[a].name, scene.bodies[b].name};
    result.frames = frames;
    result.all_frames = frames.size() == static_cast<std::size_t>(scene.frames);
    for (const std::size_t m : {mesh_a, mesh_b})
        result.triangles.push_back(scene.meshes[m].mesh.triangles.size());
    std::vector<std::vector<std::vector<double>>> ms;  // per subject, per frame, per repeat
    for (const BenchSubject& subject : options.subjects) {
        result.subjects.push_back({subject, {}, {}, {}, {}, {}});
        ms.emplace_back(frames.size());
    }
    for (std::size_t s = 0; s < options.subjects.size(); ++s) query(s, 0);

    const auto measure = [&](std::size_t s, std::size_t i, bool keep_counts) {
        const double start = thread_milliseconds();
        const Collision found = query(s, i);
        ms[s][i].push_back(thread_milliseconds() - start);
        if (keep_counts) {
            SubjectBench& subject = result.subjects[s];
            subject.n_v.push_back(found.n_v);
            subject.n_p.push_back(found.n_p);
            subject.n_u.push_back(found.n_u);
            subject.pairs.push_back(found.pairs.size());
        }
        return step();
    };
    const std::size_t count = options.subjects.size();
    for (int repeat = 0; repeat < options.repeats; ++repeat)
        for (std::size_t k = 0; k < count * frames.size(); ++k) {
            const bool cold = options.order == BenchOrder::cold;
            const std::size_t s = cold ? k % count : k / frames.size();
            const std::size_t i = cold ? k / count : k % frames.size();
            if (!measure(s, i, repeat == 0)) return std::nullopt;
        }
    for (std::size_t s = 0; s < count; ++s)
        for (const std::vector<double>& repeats : ms[s])
            result.subjects[s].ms.push_back(median(repeats));
    return result;
}

}  // namespace scb
