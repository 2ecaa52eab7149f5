#include "core/overlap/overlap_obb.h"

#include <gtest/gtest.h>

#include <array>

#include "core/explain/overlap_steps.h"
#include "core/volumes/shape.h"
#include "scb/hierarchy.h"
#include "scb/overlap.h"
#include "tests/core/overlap/volume_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many_pairs = unless_sanitized(100000, 5000);

struct BoxPair {
    ExactAabb a, b;
    Pose b_to_a;
};

/// Some flat, some with parallel axes, most near contact.
BoxPair random_box_pair(Random& random) {
    const auto half = [&] {
        Vec3 h = random_point(random).cwiseAbs();
        if (random.below(4) == 0) h[random.below(3)] = 0;
        if (random.below(4) == 0) h[random.below(3)] *= 8;
        return h;
    };
    BoxPair pair{{random_point(random), half()}, {random_point(random), half()}, {}};
    if (random.below(8) != 0) pair.b_to_a.rotation = random_rotation(random);
    const Vec3 d = random_unit_vector(random);
    const double apart =
        support(pair.a, d) + support(pair.b, rotate(pair.b_to_a.rotation.transpose(), d));
    const Vec3 center = pair.a.center + random.uniform(0.3, 1.1) * apart * d;
    pair.b_to_a.translation = center - rotate(pair.b_to_a.rotation, pair.b.center);
    return pair;
}

Aabb as_engines_test(const ExactAabb& box) { return {box.center, box.half}; }

TEST(OverlapOfAabbs, IsThatOfOrientedBoxesAllAxesOrTheFirstThree) {
    Random random(31);
    std::array<int, stage_count> ended{};
    int passed_by_three = 0;
    for (int i = 0; i < many_pairs; ++i) {
        const BoxPair p = random_box_pair(random);
        const Stage all = overlap(shape_of(p.a), shape_of(p.b), p.b_to_a);
        ASSERT_EQ(overlap(p.a, p.b, p.b_to_a), all) << i;
        const Stage three = overlap(as_engines_test(p.a), as_engines_test(p.b), p.b_to_a);
        ASSERT_EQ(three, all <= Stage::axis_a2 ? all : Stage::overlapping) << i;
        ++ended[static_cast<std::size_t>(all)];
        passed_by_three += three == Stage::overlapping && all != Stage::overlapping;
    }
    for (const Stage stage : obb_stages())
        EXPECT_GT(ended[static_cast<std::size_t>(stage)], 0) << stage_name(stage);
    EXPECT_GT(passed_by_three, many_pairs / 20);
}

TEST(OverlapOfAabbs, StepsEndWhereTheTestEnds) {
    Random random(32);
    for (int i = 0; i < many_pairs / 10; ++i) {
        const BoxPair p = random_box_pair(random);
        const Placement placed = placement(p.b_to_a, reach(p.a), reach(p.b));
        const OverlapSteps all = overlap_steps(p.a, p.b, placed);
        ASSERT_EQ(all.steps.size(), obb_stages().size());
        ASSERT_EQ(all.stage(), overlap(p.a, p.b, p.b_to_a)) << i;
        const Aabb a = as_engines_test(p.a), b = as_engines_test(p.b);
        const OverlapSteps three = overlap_steps(a, b, placed);
        ASSERT_EQ(three.steps.size(), aabb_stages().size());
        ASSERT_EQ(three.stage(), overlap(a, b, p.b_to_a)) << i;
    }
}

TEST(FitOfAabb, IsFromTheLeastToTheGreatestCoordinate) {
    Random random(33);
    for (const double far : {0.0, 1e6}) {
        const Mesh mesh = [&] {
            Mesh soup = random_soup(34, 60, 0.2);
            for (Vec3& v : soup.vertices) v += Vec3(far, -far, far);
            return soup;
        }();
        const auto hierarchy = build_hierarchy<Aabb>(mesh);
        ASSERT_EQ(validate(hierarchy, mesh), "");
        for (std::size_t i = 0; i < hierarchy.volumes.size(); ++i) {
            const TopologyNode& node = hierarchy.topology->nodes[i];
            Vec3 least = Vec3::Constant(1e300), most = -least;
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
                for (const std::uint32_t v : mesh.triangles[hierarchy.topology->order[k]]) {
                    least = least.cwiseMin(mesh.vertices[v]);
                    most = most.cwiseMax(mesh.vertices[v]);
                }
            const double rounding = 4e-16 * (1 + far);
            const Vec3 &center = hierarchy.volumes[i].center, &half = hierarchy.volumes[i].half;
            EXPECT_LE((center - half - least).cwiseAbs().maxCoeff(), rounding) << i;
            EXPECT_LE((center + half - most).cwiseAbs().maxCoeff(), rounding) << i;
        }
    }
}

TEST(Aabb, IsTheOrientedBoxOfItsShape) {
    Random random(35);
    for (int i = 0; i < 1000; ++i) {
        const ExactAabb box = random_box_pair(random).a;
        const Obb same = shape_of(box);
        EXPECT_EQ(surface_area(box), surface_area(same));
        EXPECT_EQ(volume(box), volume(same));
        EXPECT_DOUBLE_EQ(diameter(box), diameter(same));
        EXPECT_EQ(thickness(box), thickness(same));
        EXPECT_EQ(descent_size(box), descent_size(same));
        EXPECT_EQ(reach(box), reach(same));
        const Vec3 p = 2 * random_point(random);
        EXPECT_EQ(contains(box, p), contains(same, p));
        const Vec3 d = random_unit_vector(random);
        EXPECT_NEAR(support(box, d), support(same, d), 1e-15 * diameter(box));
    }
}

}  // namespace
}  // namespace scb
