#include "core/distance/first_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/distance/body_motion.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

/// A distance that is known for all times.
Approach approach_of(std::function<double(double)> distance, double speed) {
    return {std::move(distance), speed, 1e-14, 1e-4};
}

TEST(FirstContact, IsBetweenItsTwoTimes) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const double time = random.uniform(0, 1), speed = std::pow(10, random.uniform(-2, 2));
        const FirstContact found =
            first_contact(approach_of([=](double t) { return std::max(0.0, (time - t) * speed); },
                                      speed * random.uniform(1, 3)));
        ASSERT_EQ(found.outcome, ContactOutcome::contact);
        EXPECT_LE(found.not_before, time);
        EXPECT_GE(found.at_latest, time);
        EXPECT_LE(found.at_latest - found.not_before, 1e-4);
        EXPECT_LT(found.distances, 60u);
    }
}

TEST(FirstContact, FindsAShortContact) {
    // The bodies meet for a part of 1e-6 of the time.
    const FirstContact found = first_contact(
        approach_of([](double t) { return std::max(0.0, std::abs(t - 0.7312) - 5e-7); }, 1));
    ASSERT_EQ(found.outcome, ContactOutcome::contact);
    EXPECT_NEAR(found.not_before, 0.7312, 1e-4);
    EXPECT_NEAR(found.at_latest, 0.7312, 5e-7);
}

TEST(FirstContact, DistinguishesNearFromContact) {
    for (const double gap : {1e-3, 1e-6}) {
        const FirstContact apart =
            first_contact(approach_of([gap](double t) { return std::abs(t - 0.4) + gap; }, 1));
        EXPECT_EQ(apart.outcome, ContactOutcome::none) << gap;
        EXPECT_LE(apart.least_distance, 2 * gap + 1e-4);
    }
    const FirstContact grazing =
        first_contact(approach_of([](double t) { return std::abs(t - 0.4) + 1e-15; }, 1));
    EXPECT_EQ(grazing.outcome, ContactOutcome::undecided);
    EXPECT_NEAR(grazing.not_before, 0.4, 1e-4);
    EXPECT_GE(grazing.at_latest, 0.4);
}

TEST(FirstContact, GoesOnBehindATimeThatIsTooNear) {
    const FirstContact found = first_contact(approach_of(
        [](double t) { return t > 0.8 ? 0 : std::min(std::abs(t - 0.4) + 1e-15, 0.8 - t); }, 1));
    EXPECT_EQ(found.outcome, ContactOutcome::contact);
    EXPECT_LE(found.not_before, 0.4);
    EXPECT_NEAR(found.not_before, 0.4, 1e-4);
    EXPECT_GE(found.at_latest, 0.8);
    EXPECT_NEAR(found.at_latest, 0.8, 1e-4);
}

TEST(FirstContact, EndsWithATinyTolerance) {
    Approach approach = approach_of([](double t) { return t < 0.3 ? 0.3 - t + 1e-15 : 1e-15; }, 1);
    approach.tolerance = 1e-16;
    const FirstContact found = first_contact(approach);
    EXPECT_EQ(found.outcome, ContactOutcome::undecided);
    EXPECT_NEAR(found.not_before, 0.3, 1e-12);
    EXPECT_EQ(found.at_latest, 1);
}

TEST(FirstContact, KnowsTheEnds) {
    const FirstContact at_once = first_contact(approach_of([](double t) { return t; }, 1));
    EXPECT_EQ(at_once.outcome, ContactOutcome::contact);
    EXPECT_EQ(at_once.at_latest, 0);
    const FirstContact at_end = first_contact(approach_of([](double t) { return 1 - t; }, 1));
    EXPECT_EQ(at_end.outcome, ContactOutcome::contact);
    EXPECT_EQ(at_end.at_latest, 1);
    const FirstContact resting = first_contact(approach_of([](double) { return 2.0; }, 0));
    EXPECT_EQ(resting.outcome, ContactOutcome::none);
    EXPECT_EQ(resting.distances, 2u);
}

TEST(BodyMotion, GoesFromOnePoseToTheOther) {
    Random random(8);
    for (int i = 0; i < 500; ++i) {
        const Pose from = random_pose(random), to = random_pose(random);
        const BodyMotion motion(from, to);
        EXPECT_LE(motion.angle(), 3.15);
        EXPECT_EQ(motion.at(0).rotation, from.rotation);
        EXPECT_EQ(motion.at(1).rotation, to.rotation);
        EXPECT_EQ(motion.at(1).translation, to.translation);
        EXPECT_LT((motion.at(std::nextafter(1, 0)).rotation - to.rotation).norm(), 1e-13);
        for (const double time : {0.1, 0.5, 0.9}) {
            EXPECT_LT(rigidity_defect(motion.at(time)), 1e-14);
            EXPECT_LT(
                (motion.at(time).translation - from.translation - time * motion.velocity()).norm(),
                1e-12);
        }
    }
}

TEST(BodyMotion, IsNotFasterThanItSays) {
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        Mesh mesh;
        for (int v = 0; v < 3; ++v)
            mesh.vertices.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1),
                                       random.uniform(-1, 1));
        mesh.triangles = {{0, 1, 2}};
        Pose from, to = random_pose(random);
        if (i % 3 == 0) {  // nearly half a turn, and a small turn
            const double small = std::pow(10, random.uniform(-12, -1));
            const double angle = i % 2 == 0 ? small : 3.14159265358979 - small;
            to = Pose{};
            to.rotation << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle),
                0, 0, 0, 1;
        }
        to.translation = from.translation;
        const BodyMotion motion(from, to);
        const double speed = motion.turning_speed(mesh);
        double fastest = 0;
        constexpr int steps = 64;
        for (int k = 0; k < steps; ++k)
            for (const Vec3& vertex : mesh.vertices)
                fastest = std::max(
                    fastest, (transform_point(motion.at((k + 1.0) / steps), vertex) -
                              transform_point(motion.at(static_cast<double>(k) / steps), vertex))
                                     .norm() *
                                 steps);
        EXPECT_LE(fastest, speed + 1e-12);
        EXPECT_GE(fastest, 0.99 * speed - 1e-12);
    }
}

}  // namespace
}  // namespace scb
