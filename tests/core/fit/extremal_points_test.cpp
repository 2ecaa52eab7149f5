#include "core/fit/extremal_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

/// A DOP whose extremes are points of these ids, drawn at random.
Dop26 dop_of_some(Random& random, const std::vector<std::int64_t>& ids) {
    Dop26 dop;
    const auto some = [&] {
        return static_cast<double>(ids[random.below(static_cast<std::uint32_t>(ids.size()))]);
    };
    for (std::size_t i = 0; i < Dop26::directions; ++i) {
        dop.upper_id[i] = some();
        dop.lower_id[i] = some();
    }
    return dop;
}

TEST(ExtremalPoints, AreEachThereOnceInTheOrderOfTheDirections) {
    Random random(41);
    const std::vector<Vec3> all = random_points(random, 4096);
    const PointArrays arrays(all);
    for (int round = 0; round < 400; ++round) {
        // Few and many distinct ones; every other time ids that are the same modulo 64.
        std::vector<std::int64_t> ids;
        for (int i = 0; i <= round % 27; ++i)
            ids.push_back(round % 2 == 0 ? static_cast<std::int64_t>(random.below(4096))
                                         : 64 * static_cast<std::int64_t>(random.below(64)) + 7);
        const Dop26 dop = dop_of_some(random, ids);
        FewPoints points;
        ExtremalPairs pairs;
        extremal_points(dop, arrays.view(), points, pairs);
        std::vector<double> met;
        const auto expect_next = [&](double id, std::int32_t index) {
            const auto at = std::find(met.begin(), met.end(), id);
            EXPECT_EQ(index, at - met.begin());
            if (at == met.end()) met.push_back(id);
            EXPECT_EQ(points[static_cast<std::size_t>(index)], all[static_cast<std::size_t>(id)]);
        };
        for (std::size_t i = 0; i < Dop26::directions; ++i) {
            expect_next(dop.upper_id[i], pairs.upper[i]);
            expect_next(dop.lower_id[i], pairs.lower[i]);
        }
        ASSERT_EQ(points.count, met.size());
        for (std::size_t i = points.count; i % 8 != 0; ++i) EXPECT_EQ(points[i], points[0]);
    }
}

}  // namespace
}  // namespace scb
