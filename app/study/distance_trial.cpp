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

/// The queries by one setting after another. Hierarchies are built when a setting needs others.
class Trials {
  public:
    Trials(const SceneQuery& query, const std::vector<int>& frames, const TuneProgress& progress)
        : query_(query), frames_(frames), progress_(progress) {}

    std::vector<DistanceRow> rows;
    std::size_t tried = 0;

    /// Adds a row for the setting, unless it is given up. False if `progress` ended the run.
    bool count(const DistanceSetting& setting) {
        ++tried;
        prepare(setting);
        DistanceOptions limits = query_.distance->limits;
        limits.order = setting.order;
        Work work;
        std::uint64_t queries = 0;
        std::optional<IndexPair> closest;
        for (const int frame : frames_) {
            if (progress_.ends()) return false;
            if (query_.distance->within) {
                const Collision found = query_.within(frame, *query_.distance->within);
                work += {found.n_v, found.n_p};
            } else {
                limits.seed = setting.seeded ? closest : std::nullopt;
                const Distance found = query_.nearest(frame, limits);
                closest = found.triangles;
                work += {found.n_v, found.n_p};
            }
            work.picoseconds =
                assumed_distance_time(setting.hierarchy.volume, setting.layout, ++queries,
                                      work.volume_tests, work.triangle_tests);
            if (!rows.empty() && work.picoseconds > hopeless_cost * least().work.picoseconds)
                return progress_.step();
        }
        rows.push_back({setting, work});
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
    void prepare(const DistanceSetting& setting) {
        if (setting.hierarchy.split != query_.build.split) {
            query_.build.split = setting.hierarchy.split;
            query_.topologies = scenes::build_topologies(query_.scene, query_.build.topology());
            query_.hierarchies.clear();
        }
        if (setting.hierarchy.volume != query_.kind || query_.hierarchies.empty()) {
            query_.kind = setting.hierarchy.volume;
            query_.hierarchies = scenes::fit_meshes(query_.topologies, query_.kind, query_.build);
        }
        query_.packed.clear();
        if (setting.layout) query_.pack(*setting.layout);
    }

    SceneQuery query_;
    const std::vector<int>& frames_;
    const TuneProgress& progress_;
};

}  // namespace

const DistanceRow& DistanceTrial::best() const {
    return rows.size() > 1 && rows[1].work.picoseconds < rows[0].work.picoseconds ? rows[1]
                                                                                  : rows[0];
}

std::optional<DistanceTrial> try_distances(const SceneQuery& query, const std::vector<int>& frames,
                                           const TuneProgress& progress) {
    assert(query.distance && !query.is_packed());
    const bool is_within = query.distance->within.has_value();
    DistanceSetting present;
    present.hierarchy.volume = query.kind;
    present.hierarchy.split = query.build.split;
    present.hierarchy.growth = query.build.fit.growth;
    present.hierarchy.descent = query.distance->limits.descent;
    present.order = query.distance->limits.order;
    Trials run(query, frames, progress);
    const std::vector<PackedLayout> layouts = widest_layouts();
    const std::size_t seeds = is_within || frames.size() < 2 ? 1 : 2;
    progress.begin("settings counted",
                   1 + volumes.size() + (is_within ? 0 : 3) + seeds * layouts.size());
    if (!run.count(present)) return std::nullopt;
    DistanceSetting setting = present;
    setting.hierarchy.split = SplitMethod::cost;
    for (const VolumeKind volume : volumes) {
        setting.hierarchy.volume = volume;
        const bool is_present = same_hierarchies(setting.hierarchy, present.hierarchy);
        if (!is_present && !run.count(setting)) return std::nullopt;
    }
    setting = run.least().setting;
    if (!is_within) {
        for (const DistanceOrder order :
             {DistanceOrder::hybrid, DistanceOrder::nearest, DistanceOrder::depth_first}) {
            DistanceSetting other = setting;
            other.order = order;
            if (order != setting.order && !run.count(other)) return std::nullopt;
        }
        setting = run.least().setting;
        setting.seeded = true;
        if (frames.size() > 1 && !run.count(setting)) return std::nullopt;
    }
    DistanceSetting packed = setting;
    packed.hierarchy.volume = VolumeKind::scb2;
    packed.hierarchy.split = SplitMethod::cost;
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
