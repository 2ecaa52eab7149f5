#include "core/packed/collapse.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/large_pages.h"
#include "core/base/parallel_for.h"

namespace scb {
namespace {

constexpr int widest = 8;

// The least cost of representing a binary subtree by at most i + 1 wide subtrees.
using Costs = std::array<float, widest>;

// The choices of least cost: one leaf, or the same as with one place fewer, or the places are
// divided among the children of the binary node. In the last case the value plus 1 is the number of
// places of the left child. For one place, this means a node whose children are divided so.
constexpr std::uint8_t by_leaf = 200, by_fewer = 201;
using Choices = std::array<std::uint8_t, widest>;

class Collapse {
  public:
    Collapse(const Topology& topology, const std::vector<float>& cost, int width,
             int leaf_triangles)
        : nodes_(topology.nodes),
          cost_(cost),
          width_(width),
          leaf_triangles_(static_cast<std::uint32_t>(leaf_triangles)) {
        resize_large(choices_, nodes_.size());
    }

    WideTopology run(int threads) {
        weigh(0, threads);
        WideTopology wide;
        if (choices_[0][0] == by_leaf) return wide;
        wide.nodes.push_back({0, 0, 0});
        for (std::size_t at = 0; at < wide.nodes.size(); ++at) {
            const std::uint32_t node = wide.nodes[at].node;
            wide.nodes[at].first_child = static_cast<std::uint32_t>(wide.children.size());
            append_divided(node, width_ - 1, choices_[node][0], wide);
            wide.nodes[at].child_count =
                static_cast<std::uint32_t>(wide.children.size()) - wide.nodes[at].first_child;
        }
        return wide;
    }

  private:
    // Chooses for a node and all below it. The recursion is as deep as the topology, whose depth is
    // logarithmic.
    Costs weigh(std::uint32_t i, int threads) {
        constexpr std::uint32_t divided_from = 8192;
        const TopologyNode& node = nodes_[i];
        Costs left, right;
        if (node.is_leaf()) {
            left.fill(cost_[i]);
            choices_[i].fill(by_leaf);
            return left;
        }
        in_halves(
            threads, node.count >= divided_from, [&](int each) { left = weigh(node.left, each); },
            [&](int each) { right = weigh(node.left + 1, each); });
        return weigh(i, left, right);
    }

    Costs weigh(std::uint32_t i, const Costs& left, const Costs& right) {
        const TopologyNode& node = nodes_[i];
        Costs costs{};
        Choices& choices = choices_[i];
        const auto last = static_cast<std::size_t>(width_ - 1);
        // There is no gain in more places than triangles.
        const std::size_t left_places = nodes_[node.left].count;
        for (std::size_t places = 1; places <= last; ++places) {
            costs[places] = left[0] + right[places - 1];
            choices[places] = 0;
            for (std::size_t l = 1; l < std::min(places, left_places); ++l) {
                const float sum = left[l] + right[places - 1 - l];
                if (!(sum < costs[places])) continue;
                costs[places] = sum;
                choices[places] = static_cast<std::uint8_t>(l);
            }
        }
        if (node.count <= leaf_triangles_) {
            costs[0] = cost_[i];
            choices[0] = by_leaf;
        } else {
            costs[0] = cost_[i] + costs[last];
            choices[0] = choices[last];
        }
        for (std::size_t places = 1; places <= last; ++places) {
            if (costs[places] < costs[places - 1]) continue;
            costs[places] = costs[places - 1];
            choices[places] = by_fewer;
        }
        return costs;
    }

    // Appends the wide subtrees that represent binary node `i` in places + 1 places.
    void append_divided(std::uint32_t i, int places, int to_left, WideTopology& wide) {
        append(nodes_[i].left, to_left, wide);
        append(nodes_[i].left + 1, places - 1 - to_left, wide);
    }

    void append(std::uint32_t i, int places, WideTopology& wide) {
        while (choices_[i][static_cast<std::size_t>(places)] == by_fewer) --places;
        const std::uint8_t choice = choices_[i][static_cast<std::size_t>(places)];
        if (choice == by_leaf) {
            wide.children.push_back({i, WideTopology::no_node});
        } else if (places == 0) {
            wide.children.push_back({i, static_cast<std::uint32_t>(wide.nodes.size())});
            wide.nodes.push_back({i, 0, 0});
        } else {
            append_divided(i, places, choice, wide);
        }
    }

    const std::vector<TopologyNode>& nodes_;
    const std::vector<float>& cost_;
    int width_;
    std::uint32_t leaf_triangles_;
    std::vector<Choices> choices_;
};

}  // namespace

WideTopology collapse(const Topology& topology, const std::vector<float>& cost, int width,
                      int leaf_triangles, int threads) {
    assert(width >= 2 && width <= widest && leaf_triangles >= 1 && "see collapse");
    assert(cost.size() == topology.nodes.size() && "a cost for each node");
    return Collapse(topology, cost, width, leaf_triangles).run(threads);
}

}  // namespace scb
