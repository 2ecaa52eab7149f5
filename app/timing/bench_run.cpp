#include "app/timing/bench_run.h"

#include <map>
#include <memory>
#include <set>

#include "core/analysis/measure_correlation.h"

#include "render/figures/volume_titles.h"
#include "scb/error.h"

namespace scb::app {

std::string BenchSubject::title() const {
    std::string text(render::volume_title(kind));
    if (layout)
        text += " " + packed_layout_name(*layout) + (coherent ? " front" : "");
    else if (kind == VolumeKind::scb)
        text += " " + std::string(overlap_test_name(test));
    return text + (names_split ? ", " + std::string(split_method_name(split)) : "");
}

namespace {

/// The hierarchies of all meshes of a scene, of one volume and split.
struct BuiltHierarchies {
    VolumeKind kind;
    SplitMethod split;
    std::shared_ptr<const std::vector<MeshTopology>> topologies;
    std::vector<AnyHierarchy> hierarchies;
};

/// The place of the subject's in `built`, where they are added if they are not there.
std::size_t built_for(const BenchSubject& subject, const scenes::Scene& scene, BuildOptions build,
                      std::vector<BuiltHierarchies>& built) {
    std::shared_ptr<const std::vector<MeshTopology>> topologies;
    for (std::size_t i = 0; i < built.size(); ++i) {
        if (built[i].split != subject.split) continue;
        if (built[i].kind == subject.kind) return i;
        topologies = built[i].topologies;
    }
    build.split = subject.split;
    if (!topologies)
        topologies = std::make_shared<const std::vector<MeshTopology>>(
            scenes::build_topologies(scene, build.topology()));
    built.push_back({subject.kind, subject.split, topologies,
                     scenes::fit_meshes(*topologies, subject.kind, build)});
    return built.size() - 1;
}

/// Per hierarchies and CostPredictor the mean of the two meshes.
std::vector<std::vector<double>> predictors_of(const std::vector<BuiltHierarchies>& built,
                                               const scenes::Scene& scene,
                                               const std::set<std::size_t>& meshes, int threads) {
    std::vector<std::vector<double>> result(built.size(),
                                            std::vector<double>(cost_predictors().size()));
    std::map<std::pair<SplitMethod, std::size_t>, MeasuredMesh> measured;
    for (std::size_t i = 0; i < built.size(); ++i)
        for (const std::size_t m : meshes) {
            const Mesh& mesh = scene.meshes[m].mesh;
            const MeshTopology& shared = (*built[i].topologies)[m];
            const auto known = measured.find({built[i].split, m});
            const MeasuredMesh& of_mesh = known != measured.end()
                                              ? known->second
                                              : measured[{built[i].split, m}] = measured_mesh(
                                                    mesh, *shared.topology, shared.points, threads);
            const HierarchyMeasures measures =
                hierarchy_measures(built[i].hierarchies[m], of_mesh, threads);
            for (std::size_t p = 0; p < result[i].size(); ++p)
                result[i][p] +=
                    cost_predictors()[p].of(measures) / static_cast<double>(meshes.size());
        }
    return result;
}

}  // namespace

double SubjectBench::mean_ms() const { return mean(ms); }

SceneBench empty_bench(const scenes::Scene& scene, std::size_t a, std::size_t b,
                       const std::vector<BenchSubject>& subjects) {
    SceneBench bench;
    bench.scene = scene.name;
    bench.bodies = {scene.bodies[a].name, scene.bodies[b].name};
    for (const std::size_t body : {a, b})
        bench.triangles.push_back(scene.meshes[scene.bodies[body].mesh].mesh.triangles.size());
    for (const BenchSubject& subject : subjects) bench.subjects.push_back({.subject = subject});
    return bench;
}

std::optional<SceneBench> bench_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const BenchOptions& options,
                                      const std::function<bool()>& step) {
    std::vector<BuiltHierarchies> built;
    std::vector<std::size_t> built_of;  // per subject: index of `built`
    for (const BenchSubject& subject : options.subjects)
        built_of.push_back(built_for(subject, scene, options.build, built));

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
        const std::vector<AnyHierarchy>& h = built[built_of[s]].hierarchies;
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

    SceneBench result = empty_bench(scene, a, b, options.subjects);
    result.frames = frames;
    for (std::size_t s = 0; s < options.subjects.size(); ++s) {
        const BenchSubject& subject = options.subjects[s];
        const std::vector<AnyHierarchy>& h = built[built_of[s]].hierarchies;
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
        subject.pairs_hashes.push_back(pairs_hash(found.pairs));
    };
    timing.step = step;
    const auto ms = time_queries(timing);
    if (!ms) return std::nullopt;
    for (std::size_t s = 0; s < ms->size(); ++s) {
        result.subjects[s].ms = (*ms)[s];
        result.subjects[s].from_front = static_cast<double>(fronts[s].used() - fronts[s].made()) /
                                        static_cast<double>(frames.size());
    }
    if (options.measures) {
        const auto predictors =
            predictors_of(built, scene, {mesh_a, mesh_b}, options.build.threads);
        for (std::size_t s = 0; s < options.subjects.size(); ++s)
            if (!options.subjects[s].layout)
                result.subjects[s].predictors = predictors[built_of[s]];
    }
    return result;
}

}  // namespace scb::app
