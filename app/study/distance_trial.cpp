#include "app/study/distance_trial.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/analysis/assumed_time.h"
#include "scb/error.h"

namespace scb::app {
namespace {

/// Volumes with a bound that takes less than a microsecond.
constexpr std::array volumes = {VolumeKind::scb2,    VolumeKind::rss,  VolumeKind::obb,
                                VolumeKind::capsule, VolumeKind::aabb, VolumeKind::scb,
                                VolumeKind::ball};

/// Of one test of two triangles, in picoseconds.
constexpr std::uint64_t triangle_time = 225'000;

/// Of one bound, in picoseconds.
std::uint64_t bound_time(VolumeKind volume) {
    switch (volume) {
        case VolumeKind::scb:
        case VolumeKind::rss:
            return 500'000;
        case VolumeKind::scb2:
            return 565'000;
        case VolumeKind::obb:
        case VolumeKind::capsule:
            return 350'000;
        case VolumeKind::aabb:
        case VolumeKind::aabb_exact:
            return 220'000;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return 120'000;
        case VolumeKind::dop14:
        case VolumeKind::dop18:
        case VolumeKind::dop26:
            break;
    }
    return 3'200'000;
}

/// The queries by one method after another. Hierarchies are built when a method needs others.
class Trials {
  public:
    Trials(const SceneQuery& query, const std::vector<int>& frames, const TuneProgress& progress)
        : query_(query), frames_(frames), progress_(progress) {}

    std::vector<DistanceRow> rows;
    std::size_t tried = 0;

    /// Adds a row for the method, unless it is given up. False if `progress` ended the run.
    bool count(const DistanceMethod& method) {
        ++tried;
        prepare(method);
        DistanceOptions limits = query_.distance->limits;
        limits.order = method.order;
        Work work;
        std::uint64_t queries = 0;
        std::optional<IndexPair> closest;
        for (const int frame : frames_) {
            if (progress_.ends()) return false;
            if (query_.distance->within) {
                const Collision found = query_.within(frame, *query_.distance->within);
                work += {found.n_v, found.n_p};
            } else {
                limits.seed = method.seeded ? closest : std::nullopt;
                const Distance found = query_.nearest(frame, limits);
                closest = found.triangles;
                work += {found.n_v, found.n_p};
            }
            work.picoseconds =
                assumed_distance_time(method, ++queries, work.volume_tests, work.triangle_tests);
            if (!rows.empty() && work.picoseconds > hopeless_cost * least().work.picoseconds)
                return progress_.step();
        }
        rows.push_back({method, work});
        return progress_.step();
    }

    /// The row of the least cost so far; of equal ones the first.
    const DistanceRow& least() const {
        return *std::min_element(rows.begin(), rows.end(),
                                 [](const DistanceRow& x, const DistanceRow& y) {
                                     return x.work.picoseconds < y.work.picoseconds;
                                 });
    }

  private:
    void prepare(const DistanceMethod& method) {
        if (method.split != query_.build.split) {
            query_.build.split = method.split;
            query_.topologies = scenes::build_topologies(query_.scene, query_.build.topology());
            query_.hierarchies.clear();
        }
        if (method.volume != query_.kind || query_.hierarchies.empty()) {
            query_.kind = method.volume;
            query_.hierarchies = scenes::fit_meshes(query_.topologies, query_.kind, query_.build);
        }
        query_.packed.clear();
        if (method.layout) query_.pack(*method.layout);
    }

    SceneQuery query_;
    const std::vector<int>& frames_;
    const TuneProgress& progress_;
};

}  // namespace

std::uint64_t assumed_distance_time(const DistanceMethod& method, std::uint64_t queries,
                                    std::uint64_t n_v, std::uint64_t n_p) {
    if (!method.layout) return bound_time(method.volume) * n_v + triangle_time * n_p;
    const std::uint64_t bound = method.volume == VolumeKind::scb ? 35'000 : 40'000;
    const bool indexed = method.layout->corners == LeafCorners::in_mesh,
               quantized = method.layout->numbers == PackedLayout::Numbers::quantized;
    const std::uint64_t query = indexed ? 5'500'000 : quantized ? 7'500'000 : 14'000'000;
    return bound * n_v + triangle_time * n_p + query * queries;
}

const DistanceRow& DistanceTrial::best() const {
    return rows.size() > 1 && rows[1].work.picoseconds < rows[0].work.picoseconds ? rows[1]
                                                                                  : rows[0];
}

TestCosts costs_of_tests(const TraceHeader& header) {
    if (!is_of_distance(header.kind)) return assumed_costs(header);
    const VolumeKind volume = header.engine ? VolumeKind::aabb : header.volume;
    return {static_cast<double>(bound_time(volume)), static_cast<double>(triangle_time)};
}

std::optional<DistanceTrial> try_distances(const SceneQuery& query, const std::vector<int>& frames,
                                           const TuneProgress& progress) {
    assert(query.distance && !query.is_packed());
    const bool is_within = query.distance->within.has_value();
    const DistanceMethod present{query.kind, query.build.split, query.distance->limits.order};
    Trials run(query, frames, progress);
    const auto is_present = [&present](const DistanceMethod& method) {
        return method.volume == present.volume && method.split == present.split &&
               method.order == present.order;
    };
    const std::vector<PackedLayout> layouts = widest_layouts();
    const std::size_t seeds = is_within || frames.size() < 2 ? 1 : 2;
    progress.begin("settings counted",
                   1 + volumes.size() + (is_within ? 0 : 3) + seeds * layouts.size());
    if (!run.count(present)) return std::nullopt;
    DistanceMethod method = present;
    method.split = SplitMethod::cost;
    for (const VolumeKind volume : volumes) {
        method.volume = volume;
        if (!is_present(method) && !run.count(method)) return std::nullopt;
    }
    method = run.least().method;
    if (!is_within) {
        for (const DistanceOrder order :
             {DistanceOrder::hybrid, DistanceOrder::nearest, DistanceOrder::depth_first}) {
            DistanceMethod other = method;
            other.order = order;
            if (order != method.order && !run.count(other)) return std::nullopt;
        }
        method = run.least().method;
        method.seeded = true;
        if (frames.size() > 1 && !run.count(method)) return std::nullopt;
    }
    DistanceMethod packed{VolumeKind::scb2};
    packed.order = method.order;
    for (const PackedLayout& layout : layouts) {
        packed.layout = layout;
        try {
            for (std::size_t seeded = 0; seeded < seeds; ++seeded) {
                packed.seeded = seeded > 0;
                if (!run.count(packed)) return std::nullopt;
            }
        } catch (const InputError&) {
            // The layout cannot hold a mesh.
        }
    }
    DistanceTrial trial{frames, std::move(run.rows), run.tried, is_within};
    std::stable_sort(trial.rows.begin() + 1, trial.rows.end(),
                     [](const DistanceRow& x, const DistanceRow& y) {
                         return x.work.picoseconds < y.work.picoseconds;
                     });
    return trial;
}

}  // namespace scb::app
