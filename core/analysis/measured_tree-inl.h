#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/analysis/hierarchy_measures.h"
#include "core/analysis/shared_volume.h"
#include "core/base/parallel_for.h"
#include "core/base/portable_math.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/hierarchy/tree_shape.h"

namespace scb {

namespace measuring {

inline constexpr double flat = 1e-9;
inline constexpr std::size_t points_of_level = std::size_t{1} << 18, least_points = 64,
                             most_points = 4096;
/// Nodes with more children are left out of sibling overlap, since all pairs would have to be
/// tested.
inline constexpr std::size_t most_siblings = 16;

inline Vec3 random_direction(Random& random) {
    const double z = random.uniform(-1, 1), across = std::sqrt((1 - z) * (1 + z));
    const SinCos angle = sin_cos_turns(random.uniform());
    return {across * angle.cos, across * angle.sin, z};
}

}  // namespace measuring

/// A tree to measure, built by this project or by an engine.
template <Volume V>
struct MeasuredTree {
    const TreeShape& shape;
    std::span<const V> volumes;  ///< per node
    const MeasuredMesh& mesh;
    int threads;
    HierarchyMeasures result{};
    std::vector<double> sizes{};  ///< the volume of each node

    /// Creates `result.levels`, all zero except for their counts.
    void count_nodes() {
        result.levels.resize(static_cast<std::size_t>(depth(shape)) + 1);
        for (std::uint32_t i = 0; i < shape.size(); ++i) {
            if (!shape.is_reachable(i)) continue;
            LevelMeasures& level = result.levels[shape.depths[i]];
            ++level.nodes;
            if (shape.is_leaf(i)) ++level.leaves;
        }
    }

    /// Two children of one node, the smaller one first, or the left one where they are equal.
    struct Siblings {
        std::uint32_t parent = 0, smaller = 0, larger = 0;
    };

    /// All pairs of siblings, by their parents.
    std::vector<Siblings> siblings() const {
        std::vector<Siblings> pairs;
        std::vector<std::uint32_t> children;
        for (std::uint32_t i = 0; i < shape.size(); ++i) {
            children.clear();
            for (std::uint32_t child = shape.first_child[i]; child != no_index;
                 child = shape.next_sibling[child])
                children.push_back(child);
            if (!shape.is_reachable(i) || children.size() > measuring::most_siblings) continue;
            for (std::size_t x = 0; x < children.size(); ++x)
                for (std::size_t y = x + 1; y < children.size(); ++y) {
                    const bool swapped = sizes[children[y]] < sizes[children[x]];
                    pairs.push_back({i, children[swapped ? y : x], children[swapped ? x : y]});
                }
        }
        return pairs;
    }

    /// Whether the points of each of the two lie in no plane.
    bool are_solid(const Siblings& s) const {
        return mesh.hulls.solid[s.smaller] != 0 && mesh.hulls.solid[s.larger] != 0;
    }

    /// The points that each pair of siblings shares.
    std::vector<SharedPoints> shared(const std::vector<Siblings>& pairs) const {
        const std::vector<Vec3> points = halton_points(measuring::most_points);
        std::vector<SharedPoints> result_of(pairs.size());
        parallel_blocks(threads, pairs.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) {
                const V &smaller = volumes[pairs[i].smaller], &larger = volumes[pairs[i].larger];
                if (thickness(smaller) <= measuring::flat * diameter(smaller)) continue;
                const std::size_t level = shape.depths[pairs[i].parent] + std::size_t{1};
                const std::size_t count =
                    std::clamp(measuring::points_of_level / result.levels[level].nodes,
                               measuring::least_points, measuring::most_points);
                result_of[i] =
                    shared_points(smaller, larger, std::span(points).first(count), pairs[i].parent);
            }
        });
        return result_of;
    }

    void add_volumes() {
        double root_area = 0;
        for (const std::uint32_t root : shape.roots) root_area += surface_area(volumes[root]);
        for (std::uint32_t i = 0; i < shape.size(); ++i) {
            if (!shape.is_reachable(i)) continue;
            const double area = surface_area(volumes[i]), size = sizes[i];
            for (LevelMeasures* level : {&result.levels[shape.depths[i]], &result.all}) {
                level->area += area;
                level->volume += size;
                level->hull_volume += mesh.hulls.volumes[i];
                level->sah_cost +=
                    ratio(area * (shape.is_leaf(i) ? leaf_cost : inner_node_cost), root_area);
                if (mesh.hulls.solid[i] == 0) continue;
                ++level->solid;
                level->tightness += ratio(mesh.hulls.volumes[i], size);
            }
        }
    }

    void add_siblings() {
        const std::vector<Siblings> pairs = siblings();
        const std::vector<SharedPoints> found = shared(pairs);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const double size = sizes[pairs[i].smaller];
            const std::size_t below = shape.depths[pairs[i].parent] + std::size_t{1};
            for (LevelMeasures* level : {&result.levels[below], &result.all}) {
                level->overlap_volume += found[i].share() * size;
                if (!are_solid(pairs[i])) continue;
                ++level->solid_siblings;
                level->sibling_overlap += found[i].share();
                level->sibling_overlap_error += found[i].variance();
            }
        }
    }

    void finish_means(LevelMeasures& level) const {
        level.tightness = ratio(level.tightness, level.solid);
        level.sibling_overlap = ratio(level.sibling_overlap, level.solid_siblings);
        level.sibling_overlap_error =
            ratio(std::sqrt(level.sibling_overlap_error), level.solid_siblings);
    }

    /// Sums the costs of nodes that contain a sample but not its triangle: 6 for an inner node and
    /// 5 for a leaf. These are the costs as whole numbers, so that sums do not depend on order.
    void add_end_points() {
        const std::size_t samples = mesh.samples.size();
        if (samples == 0) return;
        double largest = 0;
        for (const std::uint32_t root : shape.roots)
            largest = std::max(largest, diameter(volumes[root]));
        std::vector<V> wider;
        for (const V& v : volumes) wider.push_back(enlarged(v, measuring::flat * largest));
        std::vector<std::uint64_t> of_sample(samples);
        const std::size_t levels = result.levels.size();
        std::vector<std::uint32_t> of_level(samples * levels);
        parallel_blocks(threads, samples, [&](std::size_t first, std::size_t end) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> stack;
            std::vector<std::uint32_t> own;  // the nodes with the sample's triangle, by depth
            for (std::size_t s = first; s < end; ++s) {
                own.assign(levels, no_index);
                for (std::uint32_t node = shape.holder[mesh.samples[s].triangle]; node != no_index;
                     node = shape.parents[node])
                    own[shape.depths[node]] = node;
                descend(
                    shape,
                    [&](std::uint32_t node) {
                        return contains(wider[node], mesh.samples[s].point);
                    },
                    [&](std::uint32_t node, std::uint32_t depth_of_node) {
                        if (own[depth_of_node] == node) return;
                        const std::uint32_t cost = shape.is_leaf(node) ? 5 : 6;
                        of_sample[s] += cost;
                        of_level[s * levels + depth_of_node] += cost;
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
        // Take samples at equal steps, so that these points are spread evenly, too.
        const std::size_t lines = std::min(lcv_lines, mesh.samples.size());
        if (lines == 0) return;
        const std::size_t step = mesh.samples.size() / lines;
        std::vector<std::uint64_t> leaves(lines);
        parallel_blocks(threads, lines, [&](std::size_t first, std::size_t end) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> stack;
            for (std::size_t i = first; i < end; ++i) {
                Random random(i);
                const Vec3 along = measuring::random_direction(random),
                           &point = mesh.samples[i * step].point;
                descend(
                    shape,
                    [&](std::uint32_t node) { return line_meets(volumes[node], point, along); },
                    [&](std::uint32_t node, std::uint32_t) {
                        if (shape.is_leaf(node)) ++leaves[i];
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
        // The variance has the standard error sqrt((m4 - m2^2) / n); its root has half of that over
        // the deviation.
        spread.deviation_error =
            ratio(std::sqrt(std::max(0.0, fourth - second * second) / n), 2 * spread.deviation);
        return spread;
    }

    HierarchyMeasures measure() {
        count_nodes();
        for (const LevelMeasures& level : result.levels) {
            result.all.nodes += level.nodes;
            result.all.leaves += level.leaves;
        }
        result.surface = mesh.surface;
        sizes.resize(shape.size());
        parallel_blocks(threads, shape.size(), [&](std::size_t first, std::size_t end) {
            for (std::size_t i = first; i < end; ++i) sizes[i] = volume(volumes[i]);
        });
        add_volumes();
        add_siblings();
        for (LevelMeasures& level : result.levels) finish_means(level);
        finish_means(result.all);
        add_end_points();
        add_lines();
        return std::move(result);
    }
};

}  // namespace scb
