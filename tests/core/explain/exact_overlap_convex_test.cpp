#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/explain/contact_certificate.h"
#include "core/explain/exact_overlap.h"
#include "core/explain/pair_explanation.h"
#include "core/overlap/overlap_convex.h"
#include "core/volumes/shape.h"
#include "tests/core/overlap/convex_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many_convex = unless_sanitized(1000, 100);

ConvexShape shape_of_box(const Obb& box) {
    return {box.center, 0, box.axes, [box](const Vec3& d) {
                Vec3 corner = Vec3::Zero();
                for (int i = 0; i < 3; ++i) {
                    const Vec3 axis = box.axes.col(i);
                    corner += (dot(axis, d) < 0 ? -box.half[i] : box.half[i]) * axis;
                }
                return corner;
            }};
}

TEST(ExactConvex, JudgesBoxesAsTheVerdictOfBoxesDoes) {
    Random random(11);
    int disjoint = 0, overlapping = 0;
    for (int i = 0; i < many_convex; ++i) {
        const auto box = [&] {
            const Pose pose = random_pose(random);
            Obb result{pose.translation, pose.rotation, Vec3::Zero()};
            for (int k = 0; k < 3; ++k)
                result.half[k] = random.below(6) == 0 ? 0 : random.uniform(0.02, 0.8);
            return result;
        };
        const Obb a = box(), b = box();
        const ContactCertificate expected = exact_overlap(a, b);
        const ConvexShape shape_a = shape_of_box(a), shape_b = shape_of_box(b);
        const ContactCertificate found = exact_overlap(shape_a, shape_b);
        if (expected.contact == Contact::touching) continue;
        ASSERT_EQ(contact_names[found.contact], contact_names[expected.contact]) << i;
        EXPECT_TRUE(verify(shape_a, shape_b, found)) << i;
        EXPECT_TRUE(check_certificate(shape_a, shape_b, found)) << i;
        const ContactCertificate sharp = sharpened(shape_a, shape_b, found);
        EXPECT_TRUE(check_certificate(shape_a, shape_b, sharp)) << i;
        if (found.contact == Contact::disjoint) {
            ++disjoint;
            // The distance is no less than along one of 15 axes.
            EXPECT_GE(found.margin, expected.margin * (1 - 1e-9)) << i;
        } else {
            ++overlapping;
            // The depth is the least along the axes. One of the axes attains it.
            double least = HUGE_VAL;
            const auto along = [&](Vec3 d) {
                if (!(d.norm() > 1e-9)) return;
                d.normalize();
                for (const Vec3& u : {d, Vec3(-d)})
                    least = std::min(
                        least, support(a, u) + support(b, u) - dot(u, Vec3(b.center - a.center)));
            };
            for (int p = 0; p < 3; ++p) {
                along(a.axes.col(p));
                along(b.axes.col(p));
                for (int q = 0; q < 3; ++q) along(cross(Vec3(a.axes.col(p)), Vec3(b.axes.col(q))));
            }
            EXPECT_LE(sharp.margin, least * (1 + 1e-9)) << i;
            EXPECT_GE(sharp.margin, least * 0.999 - 1e-9) << i;
        }
    }
    EXPECT_GT(disjoint, many_convex / 20);
    EXPECT_GT(overlapping, many_convex / 20);
}

TEST(ExactConvex, KnowsTheDepthOfBalls) {
    const auto ball = [](const Vec3& center, double radius) {
        return ConvexShape{center, radius, Mat3::Identity(),
                           [](const Vec3&) { return Vec3(0, 0, 0); }};
    };
    const ConvexShape a = ball(Vec3(0, 0, 0), 1);
    for (const double distance : {0.0, 0.5, 1.0, 1.4, 1.499999}) {
        const double depth = 1.5 - distance;
        const ConvexShape b = ball(distance * Vec3(2, -1, 2) / 3, 0.5);
        EXPECT_NEAR(least_depth(a, b, {HUGE_VAL, 1e-4, 100000}), depth, 2e-4 * depth + 1e-12);
        const ContactCertificate found = exact_overlap(a, b);
        EXPECT_EQ(found.contact, Contact::overlapping) << distance;
        EXPECT_TRUE(verify(a, b, found)) << distance;
    }
    EXPECT_EQ(exact_overlap(a, ball(Vec3(1.5, 0, 0), 0.5)).contact, Contact::touching);
    const ContactCertificate apart = exact_overlap(a, ball(Vec3(1.50001, 0, 0), 0.5));
    EXPECT_EQ(apart.contact, Contact::disjoint);
    EXPECT_NEAR(apart.margin, 1e-5, 1e-12);
}

template <class V>
class ExplainedConvex : public testing::Test {};
using ExplainedTypes = testing::Types<KDop14, KDop26, Rss, Capsule>;
TYPED_TEST_SUITE(ExplainedConvex, ExplainedTypes);

TYPED_TEST(ExplainedConvex, EndsAsTheTestDoesAndIsProven) {
    Random random(12);
    int rejected = 0;
    for (int i = 0; i < many_convex / 4; ++i) {
        const auto a = fitted<TypeParam>(random_cloud(random)),
                   b = fitted<TypeParam>(random_cloud(random));
        const Placement placed = placement(random_pose(random), reach(a), reach(b));
        const PairExplanation found = explain(a, b, placed);
        const Stage stage = overlap_convex(a, b, placed);
        EXPECT_EQ(found.steps.stage(), stage) << i;
        EXPECT_EQ(found.answer, Answer::correct) << i;
        EXPECT_TRUE(found.verified || found.certificate.contact == Contact::touching) << i;
        if (stage == Stage::overlapping) continue;
        ++rejected;
        const OverlapStep& last = found.steps.steps[*found.steps.decisive()];
        EXPECT_EQ(*found.steps.decisive(), found.steps.steps.size() - 1);
        EXPECT_GE(last.slack, 0);
        EXPECT_NEAR(last.left - last.reach_a - last.reach_b - placed.margin, last.slack, 1e-12);
        EXPECT_LE(last.slack, found.certificate.margin + 1e-12);
    }
    EXPECT_GT(rejected, many_convex / 40);
}

}  // namespace
}  // namespace scb
