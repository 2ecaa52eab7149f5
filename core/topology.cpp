#include "core/topology.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/random.h"

namespace scb {
namespace {

constexpr std::uint32_t sort_below = 8;

struct Primitives {
    std::vector<Box> boxes;
    std::vector<Vec3> centroids;

    explicit Primitives(const Mesh& mesh) {
        boxes.reserve(mesh.triangles.size());
        centroids.reserve(mesh.triangles.size());
        for (const Triangle& t : mesh.triangles) {
            const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
            boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
            centroids.push_back((a + b + c) / 3);
        }
    }
};

using Range = std::span<std::uint32_t>;

// Orders triangles along an axis; their indices break ties.
struct ByCentroid {
    const Primitives& primitives;
    int axis;

    bool operator()(std::uint32_t a, std::uint32_t b) const {
        const double x = primitives.centroids[a][axis], y = primitives.centroids[b][axis];
        return x < y || (x == y && a < b);
    }
};

std::array<int, 3> axes_by_length(const Vec3& sides) {
    std::array<int, 3> axes = {0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return sides[a] > sides[b]; });
    return axes;
}

// Moves the triangles whose centroid is below the plane to the front, in place as in quicksort;
// returns their number.
std::uint32_t partition(Range range, const Primitives& primitives, int axis, double plane) {
    std::size_t lower = 0, upper = range.size();
    for (;;) {
        while (lower < upper && primitives.centroids[range[lower]][axis] < plane) ++lower;
        while (lower < upper && !(primitives.centroids[range[upper - 1]][axis] < plane)) --upper;
        if (lower == upper) return static_cast<std::uint32_t>(lower);
        std::swap(range[lower], range[upper - 1]);
    }
}

bool balanced(std::uint32_t left, std::size_t count) {
    return 10 * std::uint64_t{std::min<std::uint64_t>(left, count - left)} >= count;
}

double median_of_7(Range range, const Primitives& primitives, int axis, Random random) {
    std::array<double, 7> samples;
    for (double& sample : samples)
        sample =
            primitives
                .centroids[range[random.below(static_cast<std::uint32_t>(range.size()))]][axis];
    std::sort(samples.begin(), samples.end());
    return samples[3];
}

void insertion_sort(Range range, const ByCentroid& less) {
    for (std::size_t i = 1; i < range.size(); ++i) {
        const std::uint32_t moving = range[i];
        std::size_t j = i;
        for (; j > 0 && less(moving, range[j - 1]); --j) range[j] = range[j - 1];
        range[j] = moving;
    }
}

struct Split {
    std::uint32_t left;
    SplitRule rule;
};

Split split(Range range, std::uint32_t first, const Primitives& primitives) {
    const auto count = static_cast<std::uint32_t>(range.size());
    if (count == 2) {
        // Half of all inner nodes: the same as below without the loops.
        Box box = primitives.boxes[range[0]];
        box.add(primitives.boxes[range[1]]);
        const int axis = axes_by_length(box.upper - box.lower)[0];
        if (ByCentroid{primitives, axis}(range[1], range[0])) std::swap(range[0], range[1]);
        return {1, SplitRule::sorted};
    }
    Box box;
    for (const std::uint32_t t : range) box.add(primitives.boxes[t]);
    const std::array<int, 3> axes = axes_by_length(box.upper - box.lower);
    if (count < sort_below) {
        insertion_sort(range, {primitives, axes[0]});
        return {count / 2, SplitRule::sorted};
    }
    constexpr SplitRule rules[] = {SplitRule::longest_side, SplitRule::second_side,
                                   SplitRule::third_side};
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = axes[i];
        const double middle = 0.5 * box.lower[axis] + 0.5 * box.upper[axis];
        const std::uint32_t left = partition(range, primitives, axis, middle);
        if (balanced(left, count)) return {left, rules[i]};
    }
    // Seeded by the range, so that the result does not depend on the order in which nodes are
    // visited.
    const Random random(std::uint64_t{first} << 32 | count);
    const std::uint32_t left =
        partition(range, primitives, axes[0], median_of_7(range, primitives, axes[0], random));
    if (balanced(left, count)) return {left, SplitRule::median_of_7};
    std::sort(range.begin(), range.end(), ByCentroid{primitives, axes[0]});
    return {count / 2, SplitRule::index};
}

}  // namespace

std::string_view split_rule_name(SplitRule rule) {
    constexpr std::array<std::string_view, split_rule_count> names = {
        "leaf", "longest side", "second side", "third side", "median of 7", "sorted", "index"};
    return names[static_cast<std::size_t>(rule)];
}

Topology build_topology(const Mesh& mesh) {
    const Primitives primitives(mesh);
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    Topology topology;
    topology.order.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) topology.order[t] = t;
    topology.nodes.reserve(2 * std::size_t{count} - 1);
    topology.rules.reserve(2 * std::size_t{count} - 1);
    topology.nodes.push_back({0, count, 0});
    topology.rules.push_back(SplitRule::leaf);

    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        open.pop_back();
        const TopologyNode node = topology.nodes[index];
        if (node.count == 1) continue;
        const Range range(topology.order.data() + node.first, node.count);
        const Split division = split(range, node.first, primitives);
        const auto left = static_cast<std::uint32_t>(topology.nodes.size());
        topology.nodes[index].left = left;
        topology.rules[index] = division.rule;
        topology.nodes.push_back({node.first, division.left, 0});
        topology.nodes.push_back({node.first + division.left, node.count - division.left, 0});
        topology.rules.insert(topology.rules.end(), 2, SplitRule::leaf);
        open.push_back(left + 1);
        open.push_back(left);
    }
    return topology;
}

std::vector<std::uint16_t> node_depths(const Topology& topology) {
    std::vector<std::uint16_t> depths(topology.nodes.size(), 0);
    for (std::size_t i = 0; i < topology.nodes.size(); ++i) {
        const std::uint32_t left = topology.nodes[i].left;
        if (left == 0) continue;
        depths[left] = depths[left + 1] = static_cast<std::uint16_t>(depths[i] + 1);
    }
    return depths;
}

}  // namespace scb
