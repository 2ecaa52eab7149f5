#include "scb/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

/// The distance of every triangle of A and every triangle of B.
struct AllDistances {
    std::vector<std::pair<double, IndexPair>> sorted;

    AllDistances(const Mesh& a, const Mesh& b, const Pose& b_to_a) {
        for (std::uint32_t i = 0; i < a.triangles.size(); ++i)
            for (std::uint32_t j = 0; j < b.triangles.size(); ++j)
                sorted.emplace_back(
                    triangle_distance(corners(a, i), transform_corners(b_to_a, corners(b, j)))
                        .distance,
                    IndexPair{i, j});
        std::sort(sorted.begin(), sorted.end());
    }
    double least() const { return sorted.front().first; }
    std::vector<IndexPair> within(double tolerance) const {
        std::vector<IndexPair> pairs;
        for (const auto& [distance, pair] : sorted)
            if (distance <= tolerance) pairs.push_back(pair);
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
};

/// Calls `use` with the colliders of each kind of volume.
template <class Use>
void for_each_kind(const BuiltMesh& a, const BuiltMesh& b, const Use& use) {
    for (std::size_t kind = 0; kind < all_volume_kinds().size(); ++kind) {
        SCOPED_TRACE(volume_kind_name(all_volume_kinds()[kind]));
        std::visit(
            [&]<Volume V>(const Hierarchy<V>& of_a) {
                use(Collider<V>{of_a, a.mesh},
                    Collider<V>{std::get<Hierarchy<V>>(b.hierarchies[kind]), b.mesh});
            },
            a.hierarchies[kind]);
    }
}

constexpr DistanceOrder all_orders[] = {DistanceOrder::nearest, DistanceOrder::depth_first,
                                        DistanceOrder::hybrid};

Pose some_pose(Random& random) {
    Pose pose = random.below(3) == 0 ? Pose{random_quarter_turn(random), Vec3::Zero()}
                                     : random_pose(random);
    const double apart = random.below(4) == 0 ? 0 : std::pow(10, random.uniform(-2, 1));
    pose.translation += Vec3(apart, 0.3 * apart, -0.2 * apart);
    return pose;
}

TEST(Distance, IsThatOfAllPairsByEveryVolumeOrderAndRule) {
    Random random(31);
    int apart = 0;
    for (int i = 0; i < scenes_tried / 10; ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 2 + static_cast<int>(random.below(30)))),
            b(small_mesh(random, 2 + static_cast<int>(random.below(30))));
        const Pose pose = some_pose(random);
        const AllDistances all(a.mesh, b.mesh, pose);
        apart += all.least() > 0;
        for_each_kind(a, b, [&](const auto& of_a, const auto& of_b) {
            for (const DistanceOrder order : all_orders)
                for (const DescentRule rule : all_descent_rules()) {
                    const Distance found =
                        distance(of_a, of_b, pose,
                                 {.order = order, .descent = rule, .heap = 1 + random.below(9)});
                    ASSERT_EQ(found.found.distance, all.least());
                    ASSERT_TRUE(found.triangles);
                    const std::vector<IndexPair> meeting = all.within(0);
                    if (meeting.empty())
                        ASSERT_EQ(*found.triangles, all.sorted.front().second);
                    else
                        ASSERT_TRUE(
                            std::binary_search(meeting.begin(), meeting.end(), *found.triangles));
                    EXPECT_GE(found.n_p, 1u);
                    EXPECT_EQ(found.n_v, test_count(found.stages));
                }
        });
    }
    EXPECT_GT(apart, scenes_tried / 30);
}

TEST(Distance, EndsEarlyAsItsOptionsSay) {
    Random random(37);
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 30)), b(small_mesh(random, 30));
        const Pose pose = some_pose(random);
        const AllDistances all(a.mesh, b.mesh, pose);
        const double least = all.least();
        for_each_kind(a, b, [&](const auto& of_a, const auto& of_b) {
            for (const DistanceOrder order : all_orders) {
                const auto found = [&](DistanceOptions options) {
                    options.order = order;
                    return distance(of_a, of_b, pose, options);
                };
                EXPECT_EQ(found({.enough = least * 0.9}).found.distance, least);
                const Distance near = found({.enough = 2 * least});
                EXPECT_LE(near.found.distance, 2 * least);
                EXPECT_LE(near.n_v, found({}).n_v);
                EXPECT_LE(found({.relative_error = 0.5}).found.distance, 1.5 * least);
                EXPECT_EQ(found({.limit = least}).found.distance, least);
                if (least == 0) continue;
                const Distance beyond = found({.limit = least * 0.9});
                EXPECT_FALSE(beyond.triangles);
                EXPECT_EQ(beyond.found.distance, HUGE_VAL);
                // With the answer as a seed, nothing else is nearer.
                const Distance seeded = found({.seed = all.sorted.front().second});
                EXPECT_EQ(seeded.found.distance, least);
                EXPECT_EQ(seeded.triangles, all.sorted.front().second);
                EXPECT_LE(seeded.n_v, found({.order = order}).n_v);
                const Distance worst = found({.seed = all.sorted.back().second});
                EXPECT_EQ(worst.found.distance, least);
                EXPECT_EQ(worst.triangles, all.sorted.front().second);
            }
        });
    }
}

TEST(Distance, FindsAllTrianglesWithinATolerance) {
    Random random(41);
    std::size_t most = 0;
    for (int i = 0; i < scenes_tried / 20; ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 30)), b(small_mesh(random, 30));
        const Pose pose = some_pose(random);
        const AllDistances all(a.mesh, b.mesh, pose);
        for (const double tolerance : {0.0, 0.1, all.sorted[all.sorted.size() / 3].first}) {
            const std::vector<IndexPair> pairs = all.within(tolerance);
            most = std::max(most, pairs.size());
            for_each_kind(a, b, [&](const auto& of_a, const auto& of_b) {
                const Collision found = within(of_a, of_b, pose, tolerance);
                EXPECT_TRUE(found.pairs == pairs)
                    << tolerance << " " << found.pairs.size() << " of " << pairs.size();
                EXPECT_GE(found.n_p, pairs.size());
            });
        }
    }
    EXPECT_GT(most, 100u);
}

TEST(Distance, OrdersHaveNames) {
    for (const DistanceOrder order : all_orders)
        EXPECT_EQ(distance_order_of(distance_order_name(order)), order);
    EXPECT_FALSE(distance_order_of("farthest"));
}

}  // namespace
}  // namespace scb
