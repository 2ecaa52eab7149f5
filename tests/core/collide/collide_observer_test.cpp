#include <gtest/gtest.h>

#include "tests/core/collide/collide_checks.h"
#include "tests/core/fit/point_sets.h"

namespace scb {
namespace {

TEST(CollideTemplate, TakesAnyObserverAndHierarchiesOfOneType) {
    struct Counter {
        std::uint64_t volumes = 0, triangles = 0, intersections = 0;
        void volume_test(const Step&) { ++volumes; }
        void item_test(const ItemStep& items) {
            ++triangles;
            intersections += items.hit;
        }
    };
    const Mesh a = random_soup(66, 40, 0.4), b = random_soup(67, 40, 0.4);
    const auto hierarchy_a = build_hierarchy<Scb>(a), hierarchy_b = build_hierarchy<Scb>(b);
    const Collider<Scb> collider_a{hierarchy_a, a}, collider_b{hierarchy_b, b};
    Counter counter;
    const Collision found = collide(collider_a, collider_b, Pose{}, {}, counter);
    EXPECT_EQ(counter.volumes, found.n_v);
    EXPECT_EQ(counter.triangles, found.n_p);
    EXPECT_EQ(counter.intersections, found.pairs.size());
    expect_same(collide(collider_a, collider_b, Pose{}), found);
    expect_same(query(BuiltMesh(a), BuiltMesh(b), Pose{}, QueryVariant{0, {}}), found);
}

}  // namespace
}  // namespace scb
