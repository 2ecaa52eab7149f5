#include "scb/topology.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/enum_names.h"
#include "core/base/large_pages.h"
#include "core/base/parallel_for.h"
#include "core/base/random.h"
#include "core/hierarchy/primitives.h"
#include "core/hierarchy/sah_split.h"

namespace scb {
namespace {

constexpr std::uint32_t sort_below = 8;

using Range = std::span<std::uint32_t>;

// The longest axis first; equal axes keep their order.
std::array<std::size_t, 3> axes_by_length(const Box& box) {
    const Vec3 sides = box.upper - box.lower;
    std::array<std::size_t, 3> axes = {0, 1, 2};
    const auto side = [&](std::size_t i) { return sides[static_cast<int>(axes[i])]; };
    if (side(1) > side(0)) std::swap(axes[0], axes[1]);
    if (side(2) > side(1)) std::swap(axes[1], axes[2]);
    if (side(1) > side(0)) std::swap(axes[0], axes[1]);
    return axes;
}

// Moves the triangles whose centroid is below the plane to the front; returns their number. As in
// quicksort, triangles on the wrong side are exchanged in pairs. Branches on the side of a centroid
// cannot be predicted, so triangles on the wrong side are listed without branches, a block at a
// time (Edelkamp and Weiss, "BlockQuicksort", 2016).
std::uint32_t partition(Range range, const Primitives& primitives, std::size_t axis, double plane) {
    const auto below = [&](std::size_t i) {
        return std::size_t{primitives[range[i]].centroid[axis] < plane};
    };
    std::size_t left = 0;
    for (std::size_t i = 0; i < range.size(); ++i) left += below(i);

    constexpr std::size_t block = 64;
    std::array<std::uint32_t, block> wrong_left, wrong_right;
    std::size_t lower = 0, upper = range.size(), left_first = 0, left_end = 0, right_first = 0,
                right_end = 0;
    while (lower < left || left_first < left_end) {
        if (left_first == left_end) {
            left_first = left_end = 0;
            for (const std::size_t end = std::min(left, lower + block); lower < end; ++lower) {
                wrong_left[left_end] = static_cast<std::uint32_t>(lower);
                left_end += 1 - below(lower);
            }
        }
        if (right_first == right_end) {
            right_first = right_end = 0;
            for (const std::size_t end = upper - std::min(upper - left, block); upper > end;) {
                wrong_right[right_end] = static_cast<std::uint32_t>(--upper);
                right_end += below(upper);
            }
        }
        while (left_first < left_end && right_first < right_end)
            std::swap(range[wrong_left[left_first++]], range[wrong_right[right_first++]]);
    }
    return static_cast<std::uint32_t>(left);
}

bool balanced(std::uint32_t left, std::size_t count) {
    return 10 * std::uint64_t{std::min<std::uint64_t>(left, count - left)} >= count;
}

double median_of_7(Range range, const Primitives& primitives, std::size_t axis, Random random) {
    std::array<double, 7> samples;
    for (double& sample : samples)
        sample = primitives[range[random.below(static_cast<std::uint32_t>(range.size()))]]
                     .centroid[axis];
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

Split split_by_section_3(Range range, std::uint32_t first, const Primitives& primitives) {
    const auto count = static_cast<std::uint32_t>(range.size());
    if (count == 2) {
        // A shortcut for half of all inner nodes: the same as below without the loops.
        Box box = primitives[range[0]].box();
        box.add(primitives[range[1]].box());
        const std::size_t axis = axes_by_length(box)[0];
        if (ByCentroid{primitives, axis}(range[1], range[0])) std::swap(range[0], range[1]);
        return {1, SplitRule::sorted};
    }
    Box box;
    for (const std::uint32_t t : range) box.add(primitives[t].box());
    const std::array<std::size_t, 3> axes = axes_by_length(box);
    if (count < sort_below) {
        insertion_sort(range, {primitives, axes[0]});
        return {count / 2, SplitRule::sorted};
    }
    constexpr SplitRule rules[] = {SplitRule::longest_side, SplitRule::second_side,
                                   SplitRule::third_side};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<int>(axes[i]);
        const double middle = 0.5 * box.lower[axis] + 0.5 * box.upper[axis];
        const std::uint32_t left = partition(range, primitives, axes[i], middle);
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
    constexpr EnumNames<SplitRule, split_rule_count> names = {
        "leaf",        "longest side", "second side", "third side",
        "median of 7", "sorted",       "index",       "least cost"};
    return names[rule];
}

namespace {

class Builder {
  public:
    Builder(const Mesh& mesh, const TopologyOptions& options)
        : primitives_(mesh, options.threads), options_(options) {
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
        topology_.order.resize(count);
        for (std::uint32_t t = 0; t < count; ++t) topology_.order[t] = t;
        resize_large(topology_.nodes, 2 * std::size_t{count} - 1);
        topology_.rules.resize(2 * std::size_t{count} - 1, SplitRule::leaf);
        topology_.nodes[0] = {0, count, 0};
    }

    Topology build() {
        divide({0, 1});
        return std::move(topology_);
    }

  private:
    // A node whose children are stored from nodes[next] on, followed by all nodes below them: a
    // subtree of n triangles has 2 n - 1 nodes, so every place is known beforehand.
    struct Open {
        std::uint32_t index, next;
    };

    void divide(Open root) {
        // Above some thousand triangles, the two halves are built in parallel.
        constexpr std::uint32_t divided_from = 4096;
        if (options_.threads > 1 && topology_.nodes[root.index].count >= divided_from) {
            const std::pair<Open, Open> halves = children(root);
            parallel_invoke(
                options_.threads, [&] { divide(halves.first); }, [&] { divide(halves.second); });
            return;
        }
        std::vector<Open> open = {root};
        while (!open.empty()) {
            const Open node = open.back();
            open.pop_back();
            if (topology_.nodes[node.index].count == 1) continue;
            const auto [left, right] = children(node);
            open.push_back(right);
            open.push_back(left);
        }
    }

    std::pair<Open, Open> children(Open open) {
        TopologyNode& node = topology_.nodes[open.index];
        const Split division =
            split(Range(topology_.order.data() + node.first, node.count), node.first);
        node.left = open.next;
        topology_.rules[open.index] = division.rule;
        topology_.nodes[open.next] = {node.first, division.left, 0};
        topology_.nodes[open.next + 1] = {node.first + division.left, node.count - division.left,
                                          0};
        return {{open.next, open.next + 2}, {open.next + 1, open.next + 2 * division.left}};
    }

    Split split(Range range, std::uint32_t first) const {
        if (options_.split == SplitMethod::cost)
            if (const std::uint32_t left = sah_split_(range, primitives_); left != 0)
                return {left, SplitRule::least_cost};
        return split_by_section_3(range, first, primitives_);
    }

    Primitives primitives_;
    TopologyOptions options_;
    SahSplit sah_split_ = sah_split_at(options_.simd);
    Topology topology_;
};

constexpr EnumNames<SplitMethod, 2> method_names = {"paper", "cost"};

}  // namespace

std::string_view split_method_name(SplitMethod method) { return method_names[method]; }
std::optional<SplitMethod> split_method_of(std::string_view name) {
    return method_names.find(name);
}

Topology build_topology(const Mesh& mesh, const TopologyOptions& options) {
    return Builder(mesh, options).build();
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

std::uint16_t node_depth(const Topology& topology, std::uint32_t node) {
    const std::vector<TopologyNode>& nodes = topology.nodes;
    std::uint16_t depth = 0;
    for (std::uint32_t at = 0; at != node; ++depth) {
        const std::uint32_t left = nodes[at].left;
        at = nodes[node].first < nodes[left + 1].first ? left : left + 1;
    }
    return depth;
}

}  // namespace scb
