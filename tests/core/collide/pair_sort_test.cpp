#include "core/collide/pair_sort.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace scb {
namespace {

TEST(SortPairs, SortsByAThenB) {
    Random random(101);
    std::vector<IndexPair> room;
    for (const std::size_t count : {0u, 1u, 2u, 199u, 200u, 201u, 5000u})
        for (const std::uint32_t bound : {1u, 200u, 256u, 70'000u, 0xffffffffu}) {
            std::vector<IndexPair> pairs(count);
            for (IndexPair& pair : pairs) pair = {random.below(bound), random.below(300)};
            std::vector<IndexPair> expected = pairs;
            std::sort(expected.begin(), expected.end());
            sort_pairs(pairs, room);
            ASSERT_EQ(pairs, expected) << count << " pairs below " << bound;
        }
}

}  // namespace
}  // namespace scb
