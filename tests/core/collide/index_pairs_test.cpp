#include "core/collide/index_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/random.h"

namespace scb {
namespace {

constexpr std::uint32_t largest = std::numeric_limits<std::uint32_t>::max();

// The basis, and the hashes of the texts "3 5\n" and of "0 0\n4294967295 10\n".
TEST(PairsHash, IsThatOfThePairsAsText) {
    EXPECT_EQ(hash_text(pairs_hash({})), "cbf29ce484222325");
    EXPECT_EQ(hash_text(pairs_hash(std::vector<IndexPair>{{3, 5}})), "d8056a01f3714bd9");
    EXPECT_EQ(hash_text(pairs_hash(std::vector<IndexPair>{{0, 0}, {largest, 10}})),
              "8f3d2255d4ec4dcd");
}

TEST(PairsHash, TellsPairsApartThatAreAsMany) {
    const std::vector<IndexPair> pairs = {{1, 2}, {3, 4}}, others = {{1, 2}, {3, 5}},
                                 shifted = {{12, 3}}, split = {{1, 23}};
    EXPECT_NE(pairs_hash(pairs), pairs_hash(others));
    EXPECT_NE(pairs_hash(shifted), pairs_hash(split));
}

TEST(PairsHash, GoesOnFromWhereItStarts) {
    const std::vector<IndexPair> first = {{1, 2}}, second = {{3, 4}}, both = {{1, 2}, {3, 4}};
    EXPECT_EQ(pairs_hash(second, pairs_hash(first)), pairs_hash(both));
}

TEST(PairsHash, TextHasAllDigits) { EXPECT_EQ(hash_text(0xab), "00000000000000ab"); }

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
