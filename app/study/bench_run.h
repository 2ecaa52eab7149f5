#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/study/query_timing.h"
#include "app/study/scene_query.h"
#include "core/base/statistics.h"
#include "core/collide/index_pairs.h"
#include "scb/any_packed.h"

namespace scb::app {

/// One hierarchy with one overlap test, or a packed one, which has its own test.
struct BenchSubject {
    VolumeKind kind = VolumeKind::scb;
    std::optional<OverlapTest> test{};  ///< of volumes that have several; none for distances
    std::optional<PackedLayout> layout{};
    bool coherent = false;  ///< with a PackedFront from frame to frame; packed only
    SplitMethod split = SplitMethod::section_3;
    bool names_split = false;  ///< if other subjects have other splits

    /// "SCB corrected", "SCB float8", "SCB float8 front", "ball", "ball (Ritter)", "OBB, cost".
    std::string title() const;
};

/// The measurements of one subject in each frame of a scene, in the order of SceneBench::frames.
struct SubjectBench {
    BenchSubject subject{};
    std::vector<double> ms{};  ///< processor time of a query: the median of the repeats
    std::vector<std::uint64_t> n_v{}, n_p{}, n_u{}, pairs{};
    std::vector<std::uint64_t> pairs_hashes{};
    std::vector<double> distances{};  ///< of QueryKind::distance, see QueryAnswer
    double bytes_per_triangle = 0;    ///< of the hierarchies of both bodies, topology included
    /// For a coherent subject: the share of queries that began at the front of an earlier query.
    /// The others began at the roots; some of these made a front.
    double from_front = 0;
    /// Per CostPredictor, the mean of A and B; only for reference hierarchies, and only if asked
    /// for.
    std::vector<double> predictors{};

    double mean_ms() const;
    std::uint64_t pairs_hash() const { return joined_hash(pairs_hashes); }
};

struct SceneBench {
    std::string scene;
    std::vector<std::string> bodies;     ///< names of A and B
    std::vector<std::size_t> triangles;  ///< of A and B
    std::vector<int> frames;
    bool all_frames = false;  ///< whether `frames` are all frames of the scene
    bool builtin = false;     ///< a built-in scene, perhaps one of Table 3's
    bool first = false;       ///< each query ended at its first pair, see BenchOptions
    std::optional<DistanceQuery> distance{};  ///< see BenchOptions
    std::vector<SubjectBench> subjects;
};

struct BenchOptions {
    std::vector<BenchSubject> subjects;
    CollideOptions collide;
    std::optional<DistanceQuery> distance{};  ///< none: the triangles that intersect
    BuildOptions build;                       ///< without the split, which each subject has
    bool measures = false;  ///< whether hierarchies are also measured, see HierarchyMeasures
    PackedOptions packed;
    std::size_t max_pairs = 100'000'000;  ///< of a query
    /// Each query ends at its first pair; packed layouts answer by touches(). Which pair this is
    /// depends on the hierarchy, so results have the pair 0,0 instead.
    bool first = false;
    int repeats = 1;
    BenchOrder order = BenchOrder::cold;
};

/// A bench before the measurement: no frames yet.
SceneBench empty_bench(const scenes::Scene& scene, std::size_t a, std::size_t b,
                       const BenchOptions& options);

/// Builds the hierarchies and times every query; before that it runs the first frame once, untimed.
/// `step` is called after each query and ends the measurement by returning false; then there is no
/// result. Throws InputError if a layout cannot hold a mesh, or if a query finds more than
/// max_pairs.
std::optional<SceneBench> bench_scene(const scenes::Scene& scene, std::size_t a, std::size_t b,
                                      const std::vector<int>& frames, const BenchOptions& options,
                                      const std::function<bool()>& step);

}  // namespace scb::app
