#include "core/platform/shard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "scb/error.h"

namespace scb {
namespace {

TEST(Shard, IsReadFromText) {
    EXPECT_EQ(parse_shard("2/3"), (Shard{2, 3}));
    EXPECT_EQ(parse_shard("1/1"), Shard{});
    EXPECT_EQ(parse_shard("16/16"), (Shard{16, 16}));
}

TEST(Shard, IsRefusedByName) {
    for (const char* text : {"", "/", "1", "1/", "/2", "0/2", "3/2", "0/0", "-1/2", "+1/2", "1/2/3",
                             " 1/2", "1/2 ", "1.0/2", "a/b", "1/99999999999999999999999"}) {
        try {
            parse_shard(text);
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.what(), "\"" + std::string(text) +
                                        "\" is not a shard; give K/N, the K-th of N parts, such as "
                                        "2/3.");
        }
    }
}

TEST(Shards, HaveEveryCaseOnceAndAreEven) {
    for (std::size_t n = 1; n <= 9; ++n)
        for (std::size_t cases = 0; cases < 40; ++cases) {
            std::vector<std::size_t> sizes(n);
            for (std::size_t index = 0; index < cases; ++index) {
                std::size_t owners = 0;
                for (std::size_t k = 1; k <= n; ++k) {
                    const bool owns = in_shard({k, n}, index);
                    owners += owns;
                    sizes[k - 1] += owns;
                }
                EXPECT_EQ(owners, 1u);
            }
            const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
            EXPECT_LE(*most - *least, 1u);
        }
    EXPECT_TRUE(in_shard({1, 3}, 0));
    EXPECT_TRUE(in_shard({2, 3}, 4));
}

}  // namespace
}  // namespace scb
