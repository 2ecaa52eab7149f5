#include "app/study/bench_run.h"

#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "app/study/near_query.h"
#include "core/analysis/measure_correlation.h"
#include "render/figures/figure_words.h"
#include "scb/error.h"

namespace scb::app {

std::string BenchSubject::title() const {
    std::string text(render::volume_title(kind));
    if (layout)
        text += " " + packed_layout_name(*layout) + (coherent ? " front" : "");
    else if (test)
        text += " " + std::string(overlap_test_name(*test));
    return text + (names_split ? ", " + std::string(split_method_name(split)) : "");
}

namespace {

/// The hierarchies of all meshes of a scene, with one volume and split.
struct BuiltHierarchies {
    VolumeKind kind;
    SplitMethod split;
    std::shared_ptr<const std::vector<MeshTopology>> topologies;
    std::vector<AnyHierarchy> hierarchies;
};

/// The index of the subject's hierarchies in `built`; adds them if they are missing.
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

/// Per set of hierarchies and CostPredictor: the mean of both meshes.
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

/// The queries of all subjects on two bodies of a scene.
class BenchQueries {
  public:
    /// Builds and packs the hierarchies. Refers to its arguments. Throws InputError if a layout
    /// cannot hold a mesh.
    BenchQueries(const scenes::Scene& scene, std::size_t a, std::size_t b,
                 const std::vector<int>& frames, const BenchOptions& options)
        : scene_(scene),
          meshes_{scene.bodies[a].mesh, scene.bodies[b].mesh},
          frames_(frames),
          options_(options),
          packed_(options.subjects.size()),
          fronts_(options.subjects.size()) {
        for (const BenchSubject& subject : options.subjects)
            built_of_.push_back(built_for(subject, scene, options.build, built_));
        for (const int frame : frames)
            poses_.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                           scenes::pose_at(scene.bodies[b].motion, frame)));
        for (std::size_t s = 0; s < options.subjects.size(); ++s)
            if (const std::optional<PackedLayout>& layout = options.subjects[s].layout)
                for (const std::size_t m : meshes_)
                    packed_[s].push_back(pack_any(*layout, hierarchies(s)[m], mesh(m),
                                                  scene.name + ", " + scene.meshes[m].name,
                                                  options.build.threads));
    }

    /// The query of the i-th frame. Throws InputError if it finds more than max_pairs.
    QueryAnswer query(std::size_t s, std::size_t i) {
        QueryAnswer answer =
            options_.distance ? near_query(s, i) : QueryAnswer{overlap_query(s, i)};
        Collision& found = answer.found;
        if (options_.first) {
            if (!found.pairs.empty()) found.pairs = {{0, 0}};
            return answer;
        }
        if (!found.complete || found.pairs.size() > options_.max_pairs)
            throw InputError(scene_.name + ", frame " + std::to_string(frames_[i]) +
                             ": more than " + std::to_string(options_.max_pairs) +
                             " pairs of triangles " +
                             (options_.distance ? "are that near" : "intersect") +
                             "; time other meshes or poses.");
        return answer;
    }

    /// Bytes of the hierarchies of both bodies.
    std::size_t bytes(std::size_t s) const {
        std::size_t sum = 0;
        for (const AnyPacked& packed : packed_[s]) sum += bytes_of(packed);
        if (packed_[s].empty())
            for (const std::size_t m : meshes_) sum += bytes_of(hierarchies(s)[m]);
        return sum;
    }

    void clear_front(std::size_t s) { fronts_[s].clear(); }
    /// See SubjectBench::from_front.
    double from_front(std::size_t s) const {
        return static_cast<double>(fronts_[s].used() - fronts_[s].made()) /
               static_cast<double>(frames_.size());
    }

    /// Sets the predictors of reference hierarchies.
    void measure(std::vector<SubjectBench>& subjects) const {
        const auto predictors =
            predictors_of(built_, scene_, {meshes_[0], meshes_[1]}, options_.build.threads);
        for (std::size_t s = 0; s < subjects.size(); ++s)
            if (packed_[s].empty()) subjects[s].predictors = predictors[built_of_[s]];
    }

  private:
    const Mesh& mesh(std::size_t m) const { return scene_.meshes[m].mesh; }
    const std::vector<AnyHierarchy>& hierarchies(std::size_t s) const {
        return built_[built_of_[s]].hierarchies;
    }

    Collision overlap_query(std::size_t s, std::size_t i) {
        return packed_[s].empty() ? reference_query(s, i) : packed_query(s, i);
    }

    QueryAnswer near_query(std::size_t s, std::size_t i) const {
        DistanceQuery asked = *options_.distance;
        const bool to_first = asked.within && options_.first;
        if (to_first) asked = {asked.up_to_first(), std::nullopt};
        const auto [a, b] = meshes_;
        QueryAnswer answer = packed_[s].empty()
                                 ? near_answer(hierarchies(s)[a], mesh(a), hierarchies(s)[b],
                                               mesh(b), poses_[i], asked)
                                 : near_answer(packed_[s][0], mesh(a), packed_[s][1], mesh(b),
                                               poses_[i], asked, options_.packed.level);
        if (to_first && std::isfinite(answer.distance)) answer.found.pairs = {{0, 0}};
        return answer;
    }

    Collision packed_query(std::size_t s, std::size_t i) {
        PackedOptions options = options_.packed;
        options.give_up_after = options_.max_pairs;
        const auto answer = [&](const auto& query) {
            return collision_of(query(packed_[s][0], mesh(meshes_[0]), packed_[s][1],
                                      mesh(meshes_[1]), poses_[i], options, &workspace_,
                                      options_.subjects[s].coherent ? &fronts_[s] : nullptr));
        };
        return options_.first ? answer([](const auto&... of) { return touches(of...); })
                              : answer([](const auto&... of) { return collide_packed(of...); });
    }

    Collision reference_query(std::size_t s, std::size_t i) const {
        CollideOptions options = options_.collide;
        if (const auto& test = options_.subjects[s].test) options.overlap.test = *test;
        options.max_pairs = options_.first ? 1 : options_.max_pairs + 1;
        const auto [a, b] = meshes_;
        return collide(hierarchies(s)[a], mesh(a), hierarchies(s)[b], mesh(b), poses_[i], options);
    }

    const scenes::Scene& scene_;
    std::array<std::size_t, 2> meshes_;  ///< of A and B
    const std::vector<int>& frames_;
    const BenchOptions& options_;
    std::vector<BuiltHierarchies> built_;
    std::vector<std::size_t> built_of_;           ///< per subject: index of `built_`
    std::vector<Pose> poses_;                     ///< per frame: B in A's frame
    std::vector<std::vector<AnyPacked>> packed_;  ///< per subject: both bodies if it is packed
    std::vector<PackedFront> fronts_;
    PackedWorkspace workspace_;
};

}  // namespace

double SubjectBench::mean_ms() const { return mean(ms); }

SceneBench empty_bench(const scenes::Scene& scene, std::size_t a, std::size_t b,
                       const BenchOptions& options) {
    SceneBench bench;
    bench.scene = scene.name;
    bench.bodies = {scene.bodies[a].name, scene.bodies[b].name};
    for (const std::size_t body : {a, b})
        bench.triangles.push_back(scene.meshes[scene.bodies[body].mesh].mesh.triangles.size());
    bench.first = options.first;
    bench.distance = options.distance;
    for (const BenchSubject& subject : options.subjects)
        bench.subjects.push_back({.subject = subject});
    return bench;
}

std::optional<SceneBench> bench_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const BenchOptions& options,
                                      const std::function<bool()>& step) {
    BenchQueries queries(scene, a, b, frames, options);
    SceneBench result = empty_bench(scene, a, b, options);
    result.frames = frames;
    for (std::size_t s = 0; s < options.subjects.size(); ++s) {
        result.subjects[s].bytes_per_triangle =
            static_cast<double>(queries.bytes(s)) /
            static_cast<double>(result.triangles[0] + result.triangles[1]);
        queries.query(s, 0);
    }

    QueryTiming timing;
    timing.subjects = options.subjects.size();
    timing.frames = frames.size();
    timing.repeats = options.repeats;
    timing.order = options.order;
    timing.wall = options.packed.threads > 1;
    timing.query = [&](std::size_t s, std::size_t i) { return queries.query(s, i); };
    // Each pass through the frames starts without a front.
    timing.before = [&](std::size_t s, std::size_t i) {
        if (i == 0) queries.clear_front(s);
    };
    timing.keep = [&](std::size_t s, std::size_t, const QueryAnswer& answer) {
        const Collision& found = answer.found;
        SubjectBench& subject = result.subjects[s];
        subject.distances.push_back(answer.distance);
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
        result.subjects[s].from_front = queries.from_front(s);
    }
    if (options.measures) queries.measure(result.subjects);
    return result;
}

}  // namespace scb::app
