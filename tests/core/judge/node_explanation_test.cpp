#include "core/judge/node_explanation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/volumes/any_volume.h"

namespace scb {
namespace {

/// One of each kind, about the origin, of about that size.
std::vector<NodeVolume> volumes_of_size(double s) {
    const Mat3 axes = Mat3::Identity();
    Polytope hull;
    for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
        hull.corners.push_back(s * corner);
    Scb2 two{Vec3::Zero(), s, {}};
    two.slabs = {Slab{Vec3::UnitX(), s / 2, -s / 2}, Slab{Vec3::UnitY(), s / 3, -s / 3}};
    return {Obb{Vec3::Zero(), axes, s * Vec3(1, 0.5, 0.25)},
            Ball{Vec3::Zero(), s},
            Scb{Vec3::Zero(), s, Vec3::UnitZ(), s / 2, -s / 4},
            Capsule{Vec3::Zero(), s * Vec3::UnitX(), s / 2},
            std::make_shared<const Polytope>(hull),
            two};
}

TEST(NodeExplanation, ProvesWhatExactVerdictSays) {
    Random random(3);
    int disjoint = 0, overlapping = 0;
    for (const NodeVolume& a : volumes_of_size(1))
        for (const NodeVolume& b : volumes_of_size(0.7))
            for (int trial = 0; trial < 20; ++trial) {
                Pose pose;
                for (int i = 0; i < 3; ++i) pose.translation[i] = random.uniform(-2, 2);
                const ContactCertificate verdict = exact_verdict(a, b, pose, 1e-9);
                const PairExplanation found = explain_nodes(a, b, pose, 1e-9, Stage::overlapping);
                ASSERT_EQ(found.certificate.contact, verdict.contact);
                EXPECT_EQ(proven_verdict(a, b, pose, 1e-9).has_value(),
                          std::holds_alternative<Scb2>(a) == std::holds_alternative<Scb2>(b));
                if (!proven_verdict(a, b, pose, 1e-9).has_value()) {
                    EXPECT_EQ(verdict.contact, Contact::touching);
                    continue;
                }
                EXPECT_EQ(found.verified, verdict.contact != Contact::touching);
                EXPECT_GE(found.certificate.margin, verdict.margin);
                const OverlapStep& step = found.steps.steps.at(0);
                EXPECT_EQ(step.separates, verdict.contact == Contact::disjoint);
                if (step.separates) {
                    ++disjoint;
                    EXPECT_NEAR(step.slack, found.certificate.margin, 1e-9);
                    EXPECT_EQ(found.answer, Answer::false_positive);
                } else if (verdict.contact == Contact::overlapping) {
                    ++overlapping;
                    // No direction separates them by less than the depth.
                    EXPECT_LE(step.slack, -found.certificate.margin + 1e-9);
                    EXPECT_EQ(found.answer, Answer::correct);
                }
            }
    EXPECT_GT(disjoint, 50);
    EXPECT_GT(overlapping, 50);
}

TEST(NodeExplanation, JudgesWhereTheEngineEnded) {
    const NodeVolume ball = Ball{Vec3::Zero(), 1};
    Pose near, far;
    near.translation = {1.5, 0, 0};
    far.translation = {2.5, 0, 0};
    const auto answer = [&](const Pose& pose, Stage ended) {
        return explain_nodes(ball, ball, pose, 1e-9, ended).answer;
    };
    EXPECT_EQ(answer(near, Stage::overlapping), Answer::correct);
    EXPECT_EQ(answer(near, Stage::axis_a0), Answer::false_negative);
    EXPECT_EQ(answer(far, Stage::overlapping), Answer::false_positive);
    EXPECT_EQ(answer(far, Stage::search), Answer::correct);
    // Within the tolerance either is right.
    EXPECT_EQ(explain_nodes(ball, ball, near, 0.6, Stage::axis_a0).answer, Answer::correct);
    // A step that the engine did not take rejects nothing.
    EXPECT_TRUE(explain_nodes(ball, ball, far, 0, Stage::axis_a0).steps.decisive().has_value());
    EXPECT_FALSE(
        explain_nodes(ball, ball, far, 0, Stage::overlapping).steps.decisive().has_value());
}

}  // namespace
}  // namespace scb
