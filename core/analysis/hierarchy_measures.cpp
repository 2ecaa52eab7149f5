#include "core/analysis/hierarchy_measures.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/sample_descent.h"
#include "core/analysis/shared_volume.h"
#include "core/base/parallel_for.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/base/trigonometry.h"

namespace scb {
namespace {

constexpr double flat = 1e-9;
constexpr std::size_t points_of_level = std::size_t{1} << 18, least_points = 64, most_points = 4096;

Vec3 random_direction(Random& random) {
    const double z = random.uniform(-1, 1), across = std::sqrt((1 - z) * (1 + z));
    const SinCos angle = sin_cos_turns(random.uniform());
    return {across * angle.cos, across * angle.sin, z};
}

/// A hierarchy that is being measured.
template <Volume V>
struct MeasuredHierarchy {
    const Hierarchy<V>& hierarchy;
    const MeasuredMesh& mesh;
    int threads;
    HierarchyMeasures result{};
    std::vector<double> sizes{};  ///< the volume of each node

    const Topology& topology() const { return *hierarchy.topology; }

    /// `result.levels`, all zero but for their counts.
    void count_nodes(const std::vector<std::uint16_t>& depths) {
        result.levels.resize(*std::max_element(depths.begin(), depths.end()) + std::size_t{1});
        for (std::size_t i = 0; i < depths.size(); ++i) {
            LevelMeasures& level = result.levels[depths[i]];
            ++level.nodes;
            if (topology().nodes[i].is_leaf()) ++level.leaves;
        }
    }

    /// Whether both children of a node have points in no plane.
    bool has_solid_children(const TopologyNode& n) const {
        return mesh.hulls.solid[n.left] != 0 && mesh.hulls.solid[n.left + 1] != 0;
    }

    /// What the children of each inner node share.
    std::vector<SharedPoints> siblings(const std::vector<std::uint16_t>& depths) const {
        const std::vector<Vec3> points = halton_points(most_points);
        std::vector<SharedPoints> shared(depths.size());
        parallel_blocks(threads, depths.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                const TopologyNode& n = topology().nodes[i];
                if (n.is_leaf()) continue;
                const auto [of_smaller, of_larger] = by_volume(n);
                const V &smaller = hierarchy.volumes[of_smaller],
                        &larger = hierarchy.volumes[of_larger];
                if (thickness(smaller) <= flat * diameter(smaller)) continue;
                const std::size_t count =
                    std::clamp(points_of_level / result.levels[depths[i] + std::size_t{1}].nodes,
                               least_points, most_points);
                shared[i] = shared_points(smaller, larger, std::span(points).first(count), i);
            }
        });
        return shared;
    }

    /// Both children, the smaller one first, or the left one where they are equal.
    std::pair<std::uint32_t, std::uint32_t> by_volume(const TopologyNode& n) const {
        const std::uint32_t left = n.left, right = n.left + 1;
        if (sizes[right] < sizes[left]) return {right, left};
        return {left, right};
    }

    void add_volumes(const std::vector<std::uint16_t>& depths) {
        const double root_area = surface_area(hierarchy.volumes[0]);
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const V& v = hierarchy.volumes[i];
            const double area = surface_area(v), size = sizes[i];
            for (LevelMeasures* level : {&result.levels[depths[i]], &result.all}) {
                level->area += area;
                level->volume += size;
                level->hull_volume += mesh.hulls.volumes[i];
                level->sah_cost +=
                    ratio(area * (topology().nodes[i].is_leaf() ? leaf_cost : inner_node_cost),
                          root_area);
                if (mesh.hulls.solid[i] == 0) continue;
                ++level->solid;
                level->tightness += ratio(mesh.hulls.volumes[i], size);
            }
        }
    }

    void add_siblings(const std::vector<std::uint16_t>& depths) {
        const std::vector<SharedPoints> shared = siblings(depths);
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const TopologyNode& n = topology().nodes[i];
            if (n.is_leaf()) continue;
            const double size = sizes[by_volume(n).first];
            for (LevelMeasures* level : {&result.levels[depths[i] + std::size_t{1}], &result.all}) {
                level->overlap_volume += shared[i].share() * size;
                if (!has_solid_children(n)) continue;
                ++level->solid_siblings;
                level->sibling_overlap += shared[i].share();
                level->sibling_overlap_error += shared[i].variance();
            }
        }
    }

    void finish_means(LevelMeasures& level) const {
        level.tightness = ratio(level.tightness, level.solid);
        level.sibling_overlap = ratio(level.sibling_overlap, level.solid_siblings);
        level.sibling_overlap_error =
            ratio(std::sqrt(level.sibling_overlap_error), level.solid_siblings);
    }

    /// Tests of nodes that have nothing of the samples' triangles, one inner node being 6 and a
    /// leaf 5: the ratio of their costs in whole numbers, whose sums no order changes.
    void add_end_points() {
        const std::size_t samples = mesh.samples.size();
        if (samples == 0) return;
        std::vector<std::uint32_t> position(topology().order.size());
        for (std::uint32_t i = 0; i < position.size(); ++i) position[topology().order[i]] = i;
        const double reach = flat * diameter(hierarchy.volumes[0]);
        std::vector<V> volumes;
        for (const V& v : hierarchy.volumes) volumes.push_back(enlarged(v, reach));
        std::vector<std::uint64_t> of_sample(samples);
        const std::size_t levels = result.levels.size();
        std::vector<std::uint32_t> of_level(samples * levels);
        parallel_blocks(threads, samples, [&](std::size_t first, std::size_t end) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> stack;
            for (std::size_t s = first; s < end; ++s) {
                const std::uint32_t own = position[mesh.samples[s].triangle];
                descend(
                    topology(),
                    [&](std::uint32_t node) {
                        return contains(volumes[node], mesh.samples[s].point);
                    },
                    [&](std::uint32_t node, std::uint32_t depth) {
                        const TopologyNode& n = topology().nodes[node];
                        if (n.first <= own && own - n.first < n.count) return;
                        const std::uint32_t cost = n.is_leaf() ? 5 : 6;
                        of_sample[s] += cost;
                        of_level[s * levels + depth] += cost;
                    },
                    stack);
            }
        });
        const double unit = 5 * static_cast<double>(samples);
        for (std::size_t level = 0; level < levels; ++level) {
            std::uint64_t sum = 0;
            for (std::size_t s = 0; s < samples; ++s) sum += of_level[s * levels + level];
            result.levels[level].epo = static_cast<double>(sum) / unit;
        }
        const Spread spread = spread_of(of_sample);
        result.all.epo = spread.mean / 5;
        result.epo_error = spread.deviation / 5 / std::sqrt(static_cast<double>(samples));
    }

    void add_lines() {
        // Every so many samples, so that these points are spread evenly, too.
        const std::size_t lines = std::min(lcv_lines, mesh.samples.size());
        if (lines == 0) return;
        const std::size_t step = mesh.samples.size() / lines;
        std::vector<std::uint64_t> leaves(lines);
        parallel_blocks(threads, lines, [&](std::size_t first, std::size_t end) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> stack;
            for (std::size_t i = first; i < end; ++i) {
                Random random(i);
                const Vec3 along = random_direction(random), &point = mesh.samples[i * step].point;
                descend(
                    topology(),
                    [&](std::uint32_t node) {
                        return line_meets(hierarchy.volumes[node], point, along);
                    },
                    [&](std::uint32_t node, std::uint32_t) {
                        if (topology().nodes[node].is_leaf()) ++leaves[i];
                    },
                    stack);
            }
        });
        const Spread spread = spread_of(leaves);
        result.leaf_count = spread.mean;
        result.lcv = spread.deviation;
        result.lcv_error = spread.deviation_error;
    }

    struct Spread {
        double mean = 0, deviation = 0, deviation_error = 0;
    };

    static Spread spread_of(const std::vector<std::uint64_t>& values) {
        const double n = static_cast<double>(values.size());
        Spread spread;
        for (const std::uint64_t v : values) spread.mean += static_cast<double>(v);
        spread.mean /= n;
        double second = 0, fourth = 0;
        for (const std::uint64_t v : values) {
            const double d = static_cast<double>(v) - spread.mean;
            second += d * d;
            fourth += d * d * d * d;
        }
        second /= n;
        fourth /= n;
        spread.deviation = std::sqrt(second);
        // Of the variance sqrt((m4 - m2^2) / n), and half of that over the deviation of its root.
        spread.deviation_error =
            ratio(std::sqrt(std::max(0.0, fourth - second * second) / n), 2 * spread.deviation);
        return spread;
    }

    HierarchyMeasures measure() {
        const std::vector<std::uint16_t> depths = node_depths(topology());
        count_nodes(depths);
        for (const LevelMeasures& level : result.levels) {
            result.all.nodes += level.nodes;
            result.all.leaves += level.leaves;
        }
        result.surface = mesh.surface;
        sizes.resize(depths.size());
        parallel_blocks(threads, depths.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) sizes[i] = volume(hierarchy.volumes[i]);
        });
        add_volumes(depths);
        add_siblings(depths);
        for (LevelMeasures& level : result.levels) finish_means(level);
        finish_means(result.all);
        add_end_points();
        add_lines();
        return std::move(result);
    }
};

}  // namespace

MeasuredMesh measured_mesh(const Mesh& mesh, const Topology& topology, const LeafOrder& points,
                           int threads) {
    return {node_hulls(topology, points, threads), surface_samples(mesh, epo_samples),
            surface_area(mesh)};
}

HierarchyMeasures hierarchy_measures(const AnyHierarchy& hierarchy, const MeasuredMesh& mesh,
                                     int threads) {
    return std::visit(
        [&]<Volume V>(const Hierarchy<V>& h) {
            return MeasuredHierarchy<V>{h, mesh, threads}.measure();
        },
        hierarchy);
}

}  // namespace scb
