#include "scenes/recordings/recorded_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <variant>

namespace scb::scenes {
namespace {

using Numbers = std::vector<double>;

const Numbers along_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/// How far the volume reaches from the origin along an axis, and against it.
struct Reach {
    Vec3 most, least;
};

Reach reach_of(const NodeVolume& volume) {
    const ConvexShape shape = convex_shape(volume);
    Reach reach;
    for (int k = 0; k < 3; ++k) {
        reach.most[k] = shape.center[k] + support(shape, Vec3::Unit(k));
        reach.least[k] = shape.center[k] - support(shape, Vec3(-Vec3::Unit(k)));
    }
    return reach;
}

void expect_reach(RecordedKind kind, const Numbers& numbers, const Vec3& least, const Vec3& most) {
    std::string fault = "another volume's fault";
    const NodeVolume volume = node_volume({kind, numbers}, along_axes, fault);
    EXPECT_EQ(fault, "");
    ASSERT_TRUE(has_volume(volume));
    const Reach reach = reach_of(volume);
    EXPECT_LT((reach.least - least).norm(), 1e-12) << reach.least.transpose();
    EXPECT_LT((reach.most - most).norm(), 1e-12) << reach.most.transpose();
}

TEST(RecordedVolume, ReachesAsFarAsItsNumbersSay) {
    expect_reach(RecordedKind::aabb, {1, 2, 3, 5, 8, 3}, {1, 2, 3}, {5, 8, 3});
    // Its axes are y, z and x, in this order.
    expect_reach(RecordedKind::obb, {1, 2, 3, 0, 1, 0, 0, 0, 1, 1, 0, 0, 4, 5, 6}, {-5, -2, -2},
                 {7, 6, 8});
    expect_reach(RecordedKind::ball, {1, 2, 3, 4}, {-3, -2, -1}, {5, 6, 7});
    expect_reach(RecordedKind::capsule, {1, 2, 3, 5, 0, 3, 0.5}, {0.5, -0.5, 2.5}, {5.5, 2.5, 3.5});
    expect_reach(RecordedKind::rss, {1, 2, 3, 4, 0, 0, 0, 2, 0, 0.5}, {0.5, 1.5, 2.5},
                 {5.5, 4.5, 3.5});
    expect_reach(RecordedKind::kdop, {1, 5, 2, 8, -3, 3}, {1, 2, -3}, {5, 8, 3});
    expect_reach(RecordedKind::scb, {1, 2, 3, 5, 0, 0, 1, 3, -1}, {-4, -3, 2}, {6, 7, 6});
    expect_reach(RecordedKind::hull, {1, 2, 3, 5, 8, 3, 2, 2, -4}, {1, 2, -4}, {5, 8, 3});
}

TEST(RecordedVolume, OfManyPointsIsTheirHull) {
    // A cube of 2 about (5, 5, 5) behind twenty points in it.
    Numbers numbers;
    for (int i = 0; i < 20; ++i) {
        const double x = 5 + 0.04 * i;
        numbers.insert(numbers.end(), {x, 10 - x, 5});
    }
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4}) numbers.push_back((i & bit) != 0 ? 4 : 6);
    expect_reach(RecordedKind::hull, numbers, {4, 4, 4}, {6, 6, 6});
}

TEST(RecordedVolume, OfTwoSlabsHasBoth) {
    std::string fault;
    const NodeVolume volume =
        node_volume({RecordedKind::scb2, {1, 2, 3, 5, 0, 0, 1, 3, -1, 1, 0, 0, 2, -4}}, {}, fault);
    EXPECT_EQ(fault, "");
    const Scb2& scb = std::get<Scb2>(volume);
    EXPECT_EQ(scb.c, Vec3(1, 2, 3));
    EXPECT_EQ(scb.r, 5);
    EXPECT_EQ(scb.slabs[0].n, Vec3(0, 0, 1));
    EXPECT_EQ(scb.slabs[0].e, 3);
    EXPECT_EQ(scb.slabs[0].f, -1);
    EXPECT_EQ(scb.slabs[1].n, Vec3(1, 0, 0));
    EXPECT_EQ(scb.slabs[1].e, 2);
    EXPECT_EQ(scb.slabs[1].f, -4);
}

TEST(RecordedVolume, PlanesBeyondTheBallCutNothing) {
    std::string fault;
    const Scb scb =
        std::get<Scb>(node_volume({RecordedKind::scb, {0, 0, 0, 2, 0, 0, 1, 7, -9}}, {}, fault));
    EXPECT_EQ(scb.e, 2);
    EXPECT_EQ(scb.f, -2);
}

TEST(RecordedVolume, MayBeAPointOrFlat) {
    expect_reach(RecordedKind::aabb, {1, 2, 3, 1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    expect_reach(RecordedKind::obb, {1, 2, 3, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 4}, {1, 2, -1},
                 {1, 2, 7});
    expect_reach(RecordedKind::ball, {1, 2, 3, 0}, {1, 2, 3}, {1, 2, 3});
    expect_reach(RecordedKind::scb, {0, 0, 0, 2, 0, 0, 1, 0, 0}, {-2, -2, 0}, {2, 2, 0});
    expect_reach(RecordedKind::hull, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
}

std::string fault_of(RecordedKind kind, const Numbers& numbers,
                     const Numbers& directions = along_axes) {
    std::string fault;
    EXPECT_FALSE(has_volume(node_volume({kind, numbers}, directions, fault)));
    return fault;
}

TEST(RecordedVolume, OfABoxMayBeOpenAtEachSide) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::string fault;
    for (std::size_t at = 0; at < 6; ++at) {
        Numbers numbers = {-1, -2, -3, 1, 2, 3};
        numbers[at] = at < 3 ? -infinity : infinity;
        const NodeVolume volume = node_volume({RecordedKind::aabb, numbers}, along_axes, fault);
        EXPECT_EQ(fault, "");
        EXPECT_TRUE(std::holds_alternative<OpenBox>(volume)) << at;
    }
}

TEST(RecordedVolume, ThatIsNoneSaysWhy) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(fault_of(RecordedKind::none, {}), "");
    EXPECT_EQ(fault_of(RecordedKind::ball, {0, 0, 0}), "it has 3 numbers in place of 4");
    EXPECT_EQ(fault_of(RecordedKind::kdop, {0, 1, 0, 1, 0}), "it has 5 numbers in place of 6");
    for (const double number : {infinity, -infinity, std::nan(""), 1e200, -1e200})
        EXPECT_EQ(fault_of(RecordedKind::ball, {0, number, 0, 1}),
                  "one of its numbers is not finite or too large");
    EXPECT_EQ(fault_of(RecordedKind::ball, {0, 0, 0, -1}), "its radius is below 0");
    EXPECT_EQ(fault_of(RecordedKind::capsule, {0, 0, 0, 1, 0, 0, -1}), "its radius is below 0");
    EXPECT_EQ(fault_of(RecordedKind::aabb, {0, 0, 0, 1, 1, -1}),
              "its lower corner is above the upper one");
    EXPECT_EQ(fault_of(RecordedKind::obb, {0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}),
              "its axes are no unit vectors at right angles");
    EXPECT_EQ(fault_of(RecordedKind::obb, {0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 1}),
              "its axes are no unit vectors at right angles");
    EXPECT_EQ(fault_of(RecordedKind::obb, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, -1}),
              "half a side is below 0");
    EXPECT_EQ(fault_of(RecordedKind::rss, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1}),
              "its sides are not at right angles");
    EXPECT_EQ(fault_of(RecordedKind::kdop, {}, {}), "its tree names no directions");
    EXPECT_EQ(fault_of(RecordedKind::scb, {0, 0, 0, 2, 0, 0, 2, 1, -1}),
              "its normal is no unit vector");
    EXPECT_EQ(fault_of(RecordedKind::scb, {0, 0, 0, 2, 0, 0, 1, -1, 1}),
              "its planes enclose no point");
    for (const double middle : {3.0, -3.0})
        EXPECT_EQ(fault_of(RecordedKind::scb, {0, 0, 0, 2, 0, 0, 1, middle + 0.5, middle - 0.5}),
                  "its planes cut away the whole ball");
    EXPECT_EQ(fault_of(RecordedKind::scb2, {0, 0, 0, 2, 0, 0, 1, 1, -1, 0, 0, 1, 1, -1}),
              "its normals are not at right angles");
    for (const Numbers& numbers : {Numbers{}, Numbers{1, 2, 3, 4}})
        EXPECT_EQ(fault_of(RecordedKind::hull, numbers), "it has no whole number of points");
}

}  // namespace
}  // namespace scb::scenes
