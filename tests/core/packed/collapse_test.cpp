#include "core/packed/collapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "core/base/random.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

std::vector<float> random_costs(const Topology& topology, std::uint64_t seed) {
    Random random(seed);
    std::vector<float> costs(topology.nodes.size(), 1);
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (!topology.nodes[i].is_leaf())
            for (const std::uint32_t k : {topology.nodes[i].left, topology.nodes[i].left + 1})
                costs[k] = costs[i] * static_cast<float>(random.uniform(0.2, 0.9));
    return costs;
}

double cost_of(const WideTopology& wide, const std::vector<float>& cost) {
    double sum = 0;
    for (const WideTopology::Node& node : wide.nodes) sum += static_cast<double>(cost[node.node]);
    for (const WideTopology::Child& child : wide.children)
        if (child.wide == WideTopology::no_node) sum += static_cast<double>(cost[child.node]);
    return sum;
}

/// The least cost of any wide topology, by trying all of them.
double least_cost(const Topology& topology, const std::vector<float>& cost, int width,
                  std::uint32_t leaf) {
    const auto& nodes = topology.nodes;
    // Of a node as at most so many subtrees.
    const std::function<double(std::uint32_t, int)> best = [&](std::uint32_t i, int places) {
        double least = std::numeric_limits<double>::infinity();
        if (nodes[i].count <= leaf) least = static_cast<double>(cost[i]);
        const auto divided = [&](int all) {
            for (int l = 1; l < all; ++l)
                least = std::min(
                    least, best(nodes[i].left, l) + best(nodes[i].left + 1, all - l) +
                               (all == width && places == 1 ? static_cast<double>(cost[i]) : 0.0));
        };
        if (nodes[i].is_leaf()) return least;
        if (places == 1) {
            divided(width);
        } else {
            least = std::min(least, best(i, places - 1));
            for (int l = 1; l < places; ++l)
                least =
                    std::min(least, best(nodes[i].left, l) + best(nodes[i].left + 1, places - l));
        }
        return least;
    };
    return best(0, 1);
}

TEST(Collapse, CostsTheLeast) {
    for (const int count : {2, 3, 5, 9, 14})
        for (const int width : {2, 3, 4})
            for (const int leaf : {1, 2, 4}) {
                const Topology topology = build_topology(random_soup(91, count, 0.3));
                const std::vector<float> cost = random_costs(topology, 92);
                const WideTopology wide = collapse(topology, cost, width, leaf);
                if (wide.nodes.empty()) {
                    EXPECT_LE(count, leaf);
                    continue;
                }
                EXPECT_NEAR(cost_of(wide, cost),
                            least_cost(topology, cost, width, static_cast<std::uint32_t>(leaf)),
                            1e-5)
                    << count << " " << width << " " << leaf;
            }
}

TEST(Collapse, HasEveryTriangleInOneLeaf) {
    for (const int width : {2, 4, 8}) {
        const Topology topology = build_topology(height_field(30));
        const WideTopology wide = collapse(topology, random_costs(topology, 93), width, 4);
        std::vector<char> met(topology.order.size(), 0);
        std::set<std::uint32_t> reached = {0};
        for (const WideTopology::Node& node : wide.nodes) {
            EXPECT_GE(node.child_count, 2u);
            EXPECT_LE(node.child_count, static_cast<std::uint32_t>(width));
        }
        for (const WideTopology::Child& child : wide.children) {
            const TopologyNode& node = topology.nodes[child.node];
            if (child.wide != WideTopology::no_node) {
                EXPECT_EQ(wide.nodes[child.wide].node, child.node);
                EXPECT_TRUE(reached.insert(child.wide).second);
                continue;
            }
            EXPECT_LE(node.count, 4u);
            for (std::uint32_t k = 0; k < node.count; ++k) ++met[node.first + k];
        }
        EXPECT_EQ(reached.size(), wide.nodes.size());
        EXPECT_EQ(std::count(met.begin(), met.end(), 1), static_cast<std::ptrdiff_t>(met.size()));
    }
}

TEST(Collapse, IsTheSameForAnyNumberOfThreads) {
    const Topology topology = build_topology(height_field(130));  // divided among threads twice
    const std::vector<float> cost = random_costs(topology, 94);
    for (const int width : {2, 8}) {
        const WideTopology one = collapse(topology, cost, width, 4);
        for (const int threads : {2, 5}) {
            const WideTopology other = collapse(topology, cost, width, 4, threads);
            ASSERT_EQ(one.nodes.size(), other.nodes.size());
            for (std::size_t i = 0; i < one.nodes.size(); ++i) {
                ASSERT_EQ(one.nodes[i].node, other.nodes[i].node);
                ASSERT_EQ(one.nodes[i].first_child, other.nodes[i].first_child);
                ASSERT_EQ(one.nodes[i].child_count, other.nodes[i].child_count);
            }
            ASSERT_EQ(one.children.size(), other.children.size());
            for (std::size_t i = 0; i < one.children.size(); ++i) {
                ASSERT_EQ(one.children[i].node, other.children[i].node);
                ASSERT_EQ(one.children[i].wide, other.children[i].wide);
            }
        }
    }
}

}  // namespace
}  // namespace scb
