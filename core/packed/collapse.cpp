#include "core/packed/collapse.h"

#include <array>
#include <cassert>
#include <span>

#include "core/base/parallel_for.h"

namespace scb {
namespace {

constexpr int widest = 8;

// The least cost of representing a binary subtree by at most i + 1 wide subtrees.
using Costs = std::array<float, widest>;

// How: by one leaf, by one node with children, by dividing the places among the children of the
// binary node, or as with one place fewer.
constexpr std::uint8_t by_leaf = 200, by_node = 201, by_fewer = 202;
using Choices = std::array<std::uint8_t, widest>;

class Collapse {
  public:
    Collapse(const Topology& topology, const std::vector<double>& cost, int width,
             int leaf_triangles)
        : nodes_(topology.nodes),
          cost_(cost),
          width_(width),
          leaf_triangles_(static_cast<std::uint32_t>(leaf_triangles)),
          costs_(nodes_.size()),
          choices_(nodes_.size()) {}

    WideTopology run(int threads) {
        weigh_all(0, threads);
        WideTopology wide;
        if (choices_[0][0] == by_leaf) return wide;
        wide.nodes.push_back({0, 0, 0});
        for (std::size_t at = 0; at < wide.nodes.size(); ++at) {
            const std::uint32_t node = wide.nodes[at].node;
            wide.nodes[at].first_child = static_cast<std::uint32_t>(wide.children.size());
            divide(node, width_ - 1, wide);
            wide.nodes[at].child_count =
                static_cast<std::uint32_t>(wide.children.size()) - wide.nodes[at].first_child;
        }
        return wide;
    }

  private:
    // A node and all below it, children first.
    void weigh_all(std::size_t root, int threads) {
        constexpr std::uint32_t divided_from = 8192;
        const TopologyNode& node = nodes_[root];
        if (threads > 1 && node.count >= divided_from)
            parallel_invoke(
                threads, [&] { weigh_all(node.left, threads); },
                [&] { weigh_all(node.left + 1, threads); });
        else if (!node.is_leaf())
            for (std::size_t i = node.left + 2 * std::size_t{node.count} - 2; i-- > node.left;)
                weigh(i);
        weigh(root);
    }

    void weigh(std::size_t i) {
        const TopologyNode& node = nodes_[i];
        Costs& costs = costs_[i];
        Choices& choices = choices_[i];
        if (node.is_leaf()) {
            costs.fill(static_cast<float>(cost_[i]));
            choices.fill(by_leaf);
            return;
        }
        const Costs &left = costs_[node.left], &right = costs_[node.left + 1];
        const auto divided = [&](int places, std::uint8_t& choice) {
            float least = 0;
            for (int l = 0; l < places; ++l) {
                const float sum = left[static_cast<std::size_t>(l)] +
                                  right[static_cast<std::size_t>(places - 1 - l)];
                if (l != 0 && !(sum < least)) continue;
                least = sum;
                choice = static_cast<std::uint8_t>(l);
            }
            return least;
        };
        std::uint8_t ignored = 0;
        const auto own = static_cast<float>(cost_[i]);
        costs[0] = own + divided(width_ - 1, ignored);
        choices[0] = by_node;
        if (node.count <= leaf_triangles_) {
            costs[0] = own;
            choices[0] = by_leaf;
        }
        for (int places = 1; places < width_; ++places) {
            const auto p = static_cast<std::size_t>(places);
            costs[p] = divided(places, choices[p]);
            if (costs[p] < costs[p - 1]) continue;
            costs[p] = costs[p - 1];
            choices[p] = by_fewer;
        }
    }

    // Appends what stands for the children of binary node `i` in so many places and one more.
    void divide(std::uint32_t i, int places, WideTopology& wide) {
        // Here the node's own choices do not count: it is divided.
        const TopologyNode& node = nodes_[i];
        const Costs &left = costs_[node.left], &right = costs_[node.left + 1];
        int best = 0;
        for (int l = 1; l < places; ++l)
            if (left[static_cast<std::size_t>(l)] +
                    right[static_cast<std::size_t>(places - 1 - l)] <
                left[static_cast<std::size_t>(best)] +
                    right[static_cast<std::size_t>(places - 1 - best)])
                best = l;
        append(node.left, best, wide);
        append(node.left + 1, places - 1 - best, wide);
    }

    void append(std::uint32_t i, int places, WideTopology& wide) {
        while (choices_[i][static_cast<std::size_t>(places)] == by_fewer) --places;
        const std::uint8_t choice = choices_[i][static_cast<std::size_t>(places)];
        if (choice == by_leaf) {
            wide.children.push_back({i, WideTopology::no_node});
        } else if (choice == by_node) {
            wide.children.push_back({i, static_cast<std::uint32_t>(wide.nodes.size())});
            wide.nodes.push_back({i, 0, 0});
        } else {
            append(nodes_[i].left, choice, wide);
            append(nodes_[i].left + 1, places - 1 - choice, wide);
        }
    }

    const std::vector<TopologyNode>& nodes_;
    const std::vector<double>& cost_;
    int width_;
    std::uint32_t leaf_triangles_;
    std::vector<Costs> costs_;
    std::vector<Choices> choices_;
};

}  // namespace

WideTopology collapse(const Topology& topology, const std::vector<double>& cost, int width,
                      int leaf_triangles, int threads) {
    assert(width >= 2 && width <= widest && leaf_triangles >= 1 && "see collapse");
    assert(cost.size() == topology.nodes.size() && "a cost for each node");
    return Collapse(topology, cost, width, leaf_triangles).run(threads);
}

}  // namespace scb
