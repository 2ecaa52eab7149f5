#include "core/model/node_volume.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/judge/tree_check.h"
#include "scb/error.h"
#include "scb/kdop.h"
#include "tests/core/fit/point_sets.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

const Obb some_box{Vec3(1, 2, 3), Mat3::Identity(), Vec3(0.5, 0.25, 0.125)};

NodeVolume corners_of_box() {
    Polytope hull;
    hull.center = some_box.center;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p;
        for (int i = 0; i < 3; ++i) p[i] = (corner >> i & 1) ? some_box.half[i] : -some_box.half[i];
        hull.corners.push_back(p);
    }
    return std::make_shared<const Polytope>(hull);
}

std::vector<double> dop_directions_of(const KDop26& dop) {
    std::vector<double> directions;
    for (const int which : dop.which)
        for (const double x : dop_directions[static_cast<std::size_t>(which)])
            directions.push_back(x);
    return directions;
}

std::vector<double> bounds_of(const KDop26& dop) {
    std::vector<double> bounds;
    for (std::size_t i = 0; i < dop.which.size(); ++i)
        bounds.insert(bounds.end(), {dop.lower[i], dop.upper[i]});
    return bounds;
}

/// About random points.
KDop26 some_dop(std::uint64_t seed) {
    Random random(seed);
    KDop26 dop;
    dop.lower.fill(1e9);
    dop.upper.fill(-1e9);
    for (int n = 0; n < 30; ++n) {
        const Vec3 p(random.uniform(), 2 * random.uniform(), 5 + 0.3 * random.uniform());
        for (std::size_t i = 0; i < dop.which.size(); ++i) {
            const auto& d = dop_directions[static_cast<std::size_t>(dop.which[i])];
            const double along = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
            dop.lower[i] = std::min(dop.lower[i], along);
            dop.upper[i] = std::max(dop.upper[i], along);
        }
    }
    return dop;
}

Vec3 random_direction(Random& random) {
    Vec3 d;
    do d = Vec3(random.uniform(), random.uniform(), random.uniform()) * 2 - Vec3(1, 1, 1);
    while (!(squared_norm(d) > 0.01 && squared_norm(d) < 1));
    return d / std::sqrt(squared_norm(d));
}

TEST(NodeVolume, SaysHowFarAPointIsOutside) {
    EXPECT_NEAR(excess(some_box, Vec3(1.8, 2, 3)), 0.3, 1e-15);
    EXPECT_NEAR(excess(some_box, Vec3(1.8, 2.65, 3)), 0.5, 1e-15);
    EXPECT_LE(excess(some_box, Vec3(1.5, 2.25, 3.125)), 0);
    EXPECT_NEAR(excess(corners_of_box(), Vec3(1.8, 2.65, 3)), 0.5, 1e-9);
    EXPECT_LE(excess(corners_of_box(), Vec3(1.4, 2.2, 3.1)), 1e-9);
    EXPECT_NEAR(excess(Ball{Vec3(0, 0, 1), 2}, Vec3(0, 3, 5)), 3, 1e-15);
    EXPECT_NEAR(excess(Capsule{Vec3::Zero(), Vec3(1, 0, 0), 0.5}, Vec3(2, 0, 0)), 0.5, 1e-15);
    EXPECT_NEAR(excess(Rss{Vec3::Zero(), {Vec3(1, 0, 0), Vec3(0, 1, 0)}, 0.5}, Vec3(1, 1, 2)), 1.5,
                1e-15);
    const Scb scb{Vec3::Zero(), 1, Vec3::UnitZ(), 0.25, -0.5};
    EXPECT_NEAR(excess(scb, Vec3(0, 0, 0.75)), 0.5, 1e-15);
    EXPECT_NEAR(excess(scb, Vec3(3, 0, 0)), 2, 1e-15);
    EXPECT_LE(excess(scb, Vec3(0, 0, 0.25)), 0);
    Scb2 scb2{Vec3::Zero(), 1, {}};
    scb2.slabs = {Slab{Vec3::UnitZ(), 0.25, -0.5}, Slab{Vec3::UnitX(), 1, -0.125}};
    EXPECT_NEAR(excess(scb2, Vec3(-0.5, 0, 0)), 0.375, 1e-15);
    EXPECT_NEAR(excess(scb2, Vec3(0, 0, 0.75)), 0.5, 1e-15);
    EXPECT_NEAR(excess(scb2, Vec3(0, 3, 0)), 2, 1e-15);
    EXPECT_LE(excess(scb2, Vec3(-0.125, 0, 0.25)), 0);
}

TEST(NodeVolume, NothingIsClaimedOfABallWhoseCenterIsNotInBothSlabs) {
    const auto scb2 = [](double lower) {
        Scb2 scb{Vec3::Zero(), 1, {}};
        scb.slabs = {Slab{Vec3::UnitZ(), 1, -1}, Slab{Vec3::UnitX(), 1, lower}};
        return NodeVolume(scb);
    };
    Pose apart;
    apart.translation = Vec3(0, 0, 5);
    const Pose same;
    EXPECT_EQ(exact_verdict(scb2(-0.5), scb2(-0.5), apart, 0).contact, Contact::disjoint);
    EXPECT_EQ(exact_verdict(scb2(-0.5), scb2(-0.5), same, 0).contact, Contact::overlapping);
    EXPECT_EQ(exact_verdict(scb2(0.5), scb2(-0.5), same, 0).contact, Contact::touching);
    EXPECT_EQ(exact_verdict(scb2(-0.5), scb2(0.5), same, 0).contact, Contact::touching);
    Scb2 below{Vec3::Zero(), 1, {}};
    below.slabs = {Slab{Vec3::UnitZ(), 1, -1}, Slab{Vec3::UnitX(), -0.5, -1}};
    EXPECT_EQ(exact_verdict(below, below, apart, 0).contact, Contact::touching);
}

TEST(NodeVolume, NothingIsClaimedOfABallWithTwoSlabsAndAnotherType) {
    const NodeVolume ball = Ball{Vec3::Zero(), 1};
    Scb2 scb2{Vec3::Zero(), 1, {}};
    scb2.slabs = {Slab{Vec3::UnitZ(), 1, -1}, Slab{Vec3::UnitX(), 1, -1}};
    Pose apart;
    apart.translation = Vec3(0, 0, 5);
    EXPECT_EQ(exact_verdict(ball, scb2, apart, 0).contact, Contact::touching);
    EXPECT_EQ(exact_verdict(scb2, ball, apart, 0).contact, Contact::touching);
    EXPECT_EQ(exact_verdict(ball, ball, apart, 0).contact, Contact::disjoint);
}

TEST(NodeVolume, SlabsOfAnyDirectionsAreThePolytopeOfAKDop) {
    Random random(3);
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        const KDop26 dop = some_dop(seed);
        const NodeVolume polytope = std::make_shared<const Polytope>(
            slabs_polytope(dop_directions_of(dop), bounds_of(dop)));
        const ConvexShape shape = convex_shape(polytope);
        for (int n = 0; n < 50; ++n) {
            const Vec3 d = random_direction(random);
            EXPECT_NEAR(dot(shape.center, d) + support(shape, d),
                        dot(center(dop), d) + support(dop, d), 1e-12);
            const Vec3 p = center(dop) + 2 * random.uniform() * d;
            if (std::abs(excess(polytope, p)) > 1e-12) {
                EXPECT_EQ(excess(polytope, p) < 0, contains(dop, p));
            }
        }
    }
}

TEST(NodeVolume, SlabsThatBoundNothingAreRefused) {
    const auto fault = [](std::vector<double> directions, std::vector<double> bounds) {
        try {
            slabs_polytope(directions, bounds);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(fault({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 0, 1, 0, 1}), "");
    EXPECT_EQ(fault({1, 0, 0, 0, 1, 0, 1, 1, 0}, {0, 1, 0, 1, 0, 1}),
              "its directions lie in a plane");
    // Three directions in a plane, up to rounding.
    EXPECT_EQ(fault({1, 0, 0, 0, 1, 0, 1, 1, 1e-12}, {0, 1, 0, 1, 0, 1}),
              "its directions lie in a plane");
    EXPECT_EQ(fault({1, 0, 0, 0, 1, 0, 0, 0, 0}, {0, 1, 0, 1, 0, 1}), "its direction 2 is none");
    EXPECT_EQ(fault({1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 0, 1, 2, 1}),
              "its least value is above the greatest in direction 2");
    EXPECT_EQ(fault({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, {0, 1, 0, 1, 0, 1, 5, 6}),
              "its planes enclose no point");
}

TEST(NodeVolume, OneWithoutThicknessHasCornersToo) {
    const std::vector<double> axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (const std::vector<double>& bounds :
         {std::vector<double>{0, 1, 0, 2, 3, 3}, {0, 1, 2, 2, 3, 3}, {1, 1, 2, 2, 3, 3}}) {
        const NodeVolume flat = std::make_shared<const Polytope>(slabs_polytope(axes, bounds));
        const ConvexShape shape = convex_shape(flat);
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(2 * i);
            EXPECT_NEAR(shape.center[i] + support(shape, Vec3::Unit(i)), bounds[at + 1], 1e-8);
            EXPECT_NEAR(shape.center[i] - support(shape, Vec3(-Vec3::Unit(i))), bounds[at], 1e-8);
        }
    }
}

TEST(NodeVolume, AnScbHasItsFarthestPoints) {
    Random random(5);
    for (int n = 0; n < 200; ++n) {
        const double e = random.uniform(), f = -random.uniform();
        const Scb scb{Vec3(1, 2, 3), 1, random_direction(random), e, f};
        const ConvexShape shape = convex_shape(scb);
        const Vec3 d = random_direction(random);
        EXPECT_NEAR(support(shape, d), support(scb, d), 1e-12);
        EXPECT_LE(excess(scb, Vec3(shape.center + shape.support_point(d))), 1e-12);
    }
}

TEST(NodeVolume, AnScbEndsAtItsPlaneInDirectionsNearlyAlongItsNormal) {
    Random random(6);
    for (int n = 0; n < 200; ++n) {
        const Scb scb{Vec3(1, 2, 3), 1, random_direction(random), random.uniform(), -1};
        const ConvexShape shape = convex_shape(scb);
        Vec3 side = cross(scb.n, random_direction(random));
        side /= std::sqrt(squared_norm(side));
        const double tilt = std::ldexp(1.0, -10 - static_cast<int>(random.below(38)));
        const Vec3 point = shape.support_point(scb.n + tilt * side);
        EXPECT_NEAR(dot(point, scb.n), scb.e, 1e-14) << tilt;
        EXPECT_NEAR(squared_norm(point), 1, 1e-14);
        EXPECT_GT(dot(point, side), 0);
    }
}

TEST(NodeVolume, VerdictsDoNotDependOnHowAVolumeIsTold) {
    Random random(7);
    for (int n = 0; n < 300; ++n) {
        Pose pose;
        pose.translation = 1.2 * random_direction(random);
        const Contact as_boxes = exact_verdict(some_box, some_box, pose, 1e-6).contact;
        EXPECT_EQ(exact_verdict(corners_of_box(), some_box, pose, 1e-6).contact, as_boxes);
        EXPECT_EQ(exact_verdict(corners_of_box(), corners_of_box(), pose, 1e-6).contact, as_boxes);
    }
}

TEST(NodeVolume, WithinTheToleranceVolumesTouch) {
    Pose pose;
    for (const double gap : {1e-4, -1e-4}) {
        pose.translation = Vec3(2 * some_box.half[0] + gap, 0, 0);
        EXPECT_EQ(exact_verdict(some_box, some_box, pose, 1e-3).contact, Contact::touching);
        EXPECT_EQ(exact_verdict(some_box, some_box, pose, 1e-5).contact,
                  gap > 0 ? Contact::disjoint : Contact::overlapping);
    }
    EXPECT_EQ(exact_verdict(NodeVolume{}, some_box, {}, 0).contact, Contact::touching);
}

// Along the normal, what is left of the direction across it is rounding.
TEST(NodeVolume, ASlabCutBallEndsAtItsPlanes) {
    Random random(3);
    for (int n = 0; n < 1000; ++n) {
        const Vec3 normal = random_direction(random);
        const NodeVolume scb = Scb{Vec3(1, 2, 3), 10, normal, 1, -2};
        const ConvexShape shape = convex_shape(scb);
        for (const Vec3& d : {normal, Vec3(1e-3 * normal), Vec3(normal + 1e-16 * Vec3(1, -1, 1))})
            EXPECT_NEAR(dot(shape.support_point(d), normal), 1, 1e-12);
        EXPECT_NEAR(dot(shape.support_point(Vec3(-normal)), normal), -2, 1e-12);
        // A ball half a unit beyond the plane.
        const NodeVolume ball = Ball{Vec3(1, 2, 3) + 1.75 * normal, 0.25};
        EXPECT_EQ(exact_verdict(scb, ball, Pose{}, 1e-9).contact, Contact::disjoint);
    }
}

TEST(NodeVolume, AnOpenBoxKeepsItsFiniteSides) {
    const NodeVolume open = OpenBox{Vec3::Zero(), Vec3::Constant(HUGE_VAL)},
                     floor = OpenBox{Vec3::Constant(-HUGE_VAL), Vec3(HUGE_VAL, HUGE_VAL, 3)};
    const ConvexShape box = convex_shape(box_between(Vec3::Constant(-5), Vec3::Constant(-4)));
    EXPECT_NEAR(reach_beyond(convex_shape(open), box), 5, 1e-9);
    EXPECT_NEAR(box_about(convex_shape(open)).lower[0], 0, 1e-9);
    EXPECT_NEAR(box_about(convex_shape(floor)).upper[2], 3, 1e-9);
}

TEST(NodeVolume, WhereThereIsNoExactTestThereIsNoVerdict) {
    Scb2 scb;
    scb.c = Vec3::Zero();
    scb.r = 1;
    scb.slabs = {Slab{Vec3::UnitX(), 0.5, -0.5}, Slab{Vec3::UnitY(), 0.5, -0.5}};
    const NodeVolume lens = scb, ball = Ball{Vec3::Zero(), 1};
    EXPECT_TRUE(proven_verdict(lens, lens, Pose{}, 0));
    EXPECT_FALSE(proven_verdict(lens, ball, Pose{}, 0));
    EXPECT_FALSE(proven_verdict(ball, NodeVolume{}, Pose{}, 0));
    // Half spaces that are not parallel meet somewhere, however far away.
    const NodeVolume below = OpenBox{Vec3::Constant(-HUGE_VAL), Vec3(HUGE_VAL, HUGE_VAL, 0)},
                     above = OpenBox{Vec3(-HUGE_VAL, -HUGE_VAL, 10), Vec3::Constant(HUGE_VAL)};
    const double sine = 1.0 / 64, cosine = std::sqrt(1 - sine * sine);
    Pose leaning;
    leaning.rotation << cosine, 0, sine, 0, 1, 0, -sine, 0, cosine;
    EXPECT_FALSE(proven_verdict(below, above, leaning, 0));
    EXPECT_EQ(proven_verdict(below, above, Pose{}, 0)->contact, Contact::disjoint);
}

/// A random ball cut by two slabs, often by one or none.
Scb2 random_cut_ball(Random& random) {
    Scb2 scb;
    scb.c = random_point(random);
    scb.r = 0.1 + random.uniform();
    const Mat3 axes = random_pose(random).rotation;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto end = [&] { return random.below(4) == 0 ? scb.r : scb.r * random.uniform(); };
        scb.slabs[i] = {axes.col(static_cast<int>(i)), end(), -end()};
    }
    return scb;
}

TEST(NodeVolume, TheExactShapeOfACutBallReachesAsFarAsTheBall) {
    Random random(31);
    for (int i = 0; i < 2000; ++i) {
        const Scb2 scb = random_cut_ball(random);
        const ConvexShape shape = exact_shape(AnyVolume(scb));
        for (int k = 0; k < 8; ++k) {
            // Along a normal and an axis, too.
            const Vec3 d = k == 0   ? scb.slabs[0].n
                           : k == 1 ? long_axis(scb)
                                    : Vec3(random_pose(random).rotation.col(0));
            const Vec3 point = shape.support_point(d);
            EXPECT_NEAR(dot(point, d), support(scb, d), 1e-14 * scb.r);
            EXPECT_LE(excess(scb, scb.c + point), 1e-14);
        }
    }
}

TEST(NodeVolume, CutBallsAreJudgedByTheirDistance) {
    Random random(32);
    int near = 0, far = 0;
    for (int i = 0; i < 500; ++i) {
        const NodeVolume a = random_cut_ball(random), b = random_cut_ball(random);
        Pose pose = random_pose(random);
        pose.translation *= 3;
        // The least distance of points of both is above their distance.
        double least = HUGE_VAL;
        const ConvexShape of_a = exact_shape(AnyVolume(std::get<Scb2>(a))),
                          of_b = placed(exact_shape(AnyVolume(std::get<Scb2>(b))), pose);
        for (int k = 0; k < 200; ++k) {
            const Vec3 d = random_pose(random).rotation.col(0);
            least =
                std::min(least, std::sqrt(squared_norm(Vec3(of_b.center + of_b.support_point(-d) -
                                                            of_a.center - of_a.support_point(d)))));
        }
        // The bound along the same directions is below it.
        double bound = 0;
        for (int k = 0; k < 200; ++k)
            bound =
                std::max(bound, proven_gap(of_a, of_b, Vec3(random_pose(random).rotation.col(0))));
        const auto above = proven_verdict(a, b, pose, 0, 1.01 * least);
        ASSERT_TRUE(above);
        EXPECT_EQ(above->contact, Contact::overlapping);
        ++near;
        if (bound == 0) continue;
        const auto below = proven_verdict(a, b, pose, 0, 0.99 * bound);
        ASSERT_TRUE(below);
        EXPECT_EQ(below->contact, Contact::disjoint);
        ++far;
    }
    EXPECT_GT(near, 100);
    EXPECT_GT(far, 100);
}

}  // namespace
}  // namespace scb
