#include "render/web/tree_blocks.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <set>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/any_hierarchy.h"
#include "tests/core/fit/point_sets.h"

namespace scb::render {
namespace {

std::vector<std::uint8_t> from_base64(const std::string& text) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(alphabet.find(c));
        count += 6;
        if (count >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
    }
    return bytes;
}

/// As blocks.js does it.
template <class T>
std::vector<T> unpacked(const BlockStore& store, std::size_t number) {
    const BlockStore::Block& block = store.blocks().at(number);
    const std::vector<std::uint8_t> packed = from_base64(block.text);
    std::vector<std::uint8_t> planes(block.count * sizeof(T) + 1);
    uLongf size = static_cast<uLongf>(planes.size());
    EXPECT_EQ(uncompress(planes.data(), &size, packed.data(), static_cast<uLong>(packed.size())),
              Z_OK);
    EXPECT_EQ(size, block.count * sizeof(T));
    std::vector<T> values(block.count);
    for (std::size_t i = 0; i < block.count; ++i)
        for (std::size_t k = 0; k < sizeof(T); ++k)
            reinterpret_cast<std::uint8_t*>(&values[i])[k] = planes[k * block.count + i];
    return values;
}

TEST(BlockStore, GivesBackWhatItTook) {
    BlockStore store;
    const std::vector<double> numbers = {0, -1.5, 1e300, 3};
    const std::vector<std::uint32_t> none;
    EXPECT_EQ(store.add(std::span(numbers)), 0u);
    EXPECT_EQ(store.add(std::span(none)), 1u);
    EXPECT_EQ(unpacked<double>(store, 0), numbers);
    EXPECT_TRUE(unpacked<std::uint32_t>(store, 1).empty());
}

class TreeBlocksOf : public testing::TestWithParam<VolumeKind> {};

TEST_P(TreeBlocksOf, HaveEachNodeOnceLevelByLevel) {
    const Mesh mesh = random_soup(3, 60, 0.2);
    const auto topology = std::make_shared<const Topology>(build_topology(mesh));
    const AnyHierarchy hierarchy = fit_any(GetParam(), topology, leaf_order(mesh, *topology));
    const Tree tree(hierarchy);
    BlockStore store;
    const TreeBlocks blocks = tree_blocks(
        tree,
        [](std::uint32_t node) {
            return Rgba8{static_cast<std::uint8_t>(node), 1, 2};
        },
        store);
    const auto order = unpacked<std::uint32_t>(store, blocks.order),
               children = unpacked<std::uint32_t>(store, blocks.children);
    ASSERT_EQ(order.size(), tree.size());
    EXPECT_EQ(std::set(order.begin(), order.end()).size(), tree.size());
    // The children of the nodes follow each other behind the roots.
    std::size_t next = tree.shape().roots.size(), at = 0;
    for (std::size_t slot = 0; slot < order.size(); ++slot)
        for (std::uint32_t i = 0; i < children[slot]; ++i)
            EXPECT_EQ(tree.shape().parents[order[next++]], order[slot]);
    EXPECT_EQ(next, order.size());
    std::size_t depth = 0;
    for (const LevelBlocks& part : blocks.parts) {
        const auto shapes = unpacked<std::uint8_t>(store, part.shapes),
                   colors = unpacked<std::uint8_t>(store, part.colors);
        const auto numbers = unpacked<float>(store, part.numbers);
        ASSERT_EQ(numbers.size() % shapes.size(), 0u) << "all are of one shape";
        const std::size_t each = numbers.size() / shapes.size();
        std::size_t extras = 0, first = at;
        for (std::size_t level = 0; level < part.levels; ++level, ++depth)
            for (std::size_t i = 0; i < blocks.counts.at(depth); ++i, ++at) {
                EXPECT_EQ(tree.shape().depths[order[at]], depth);
                EXPECT_EQ(colors.at(3 * (at - first)), static_cast<std::uint8_t>(order[at]));
                const Vec3 center = scb::center(tree.volume(order[at])) - blocks.center;
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_EQ(numbers.at(each * (at - first) + k),
                              static_cast<float>(center[static_cast<int>(k)]));
                if (part.has_extras)
                    extras += unpacked<std::uint32_t>(store, part.extras)[at - first] & 0x7fffffffu;
            }
        EXPECT_EQ(at - first, shapes.size());
        if (part.has_extras) {
            EXPECT_EQ(unpacked<float>(store, part.texels).size(), 4 * extras);
        }
    }
    EXPECT_EQ(depth, blocks.counts.size());
    EXPECT_EQ(at, order.size());
}

INSTANTIATE_TEST_SUITE_P(Kinds, TreeBlocksOf, testing::ValuesIn(all_volume_kinds()),
                         [](const auto& kind) {
                             std::string name(volume_kind_name(kind.param));
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace scb::render
