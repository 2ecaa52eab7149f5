#include "core/analysis/distance_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/core/collide/small_scenes.h"

namespace scb {
namespace {

/// A query of two bodies, with its steps.
struct Asked {
    const AnyHierarchy &a, &b;
    TraceHeader header;
    QueryTrace frame;
};

Asked nearest_query(const BuiltMesh& a, const BuiltMesh& b, std::size_t kind, const Pose& pose,
                    DistanceOrder order) {
    Asked asked{a.hierarchies[kind], b.hierarchies[kind], {}, {}};
    asked.header.kind = QueryKind::distance;
    asked.header.volume = all_volume_kinds()[kind];
    asked.header.distance.order = order;
    StepRecorder recorder;
    const Distance found =
        distance(asked.a, a.mesh, asked.b, b.mesh, pose, asked.header.distance, recorder);
    asked.frame.b_to_a = pose;
    asked.frame.found.n_v = found.n_v;
    asked.frame.found.pairs = {*found.triangles};
    asked.frame.nearest = found.found;
    asked.frame.steps = std::move(recorder.steps);
    return asked;
}

/// The triangles of a node.
std::span<const std::uint32_t> triangles_of(const AnyHierarchy& hierarchy, std::uint32_t node) {
    const Topology& topology = topology_of(hierarchy);
    return std::span(topology.order)
        .subspan(topology.nodes[node].first, topology.nodes[node].count);
}

TEST(DistanceSteps, AreJudgedByAllTrianglesBelow) {
    Random random(5);
    std::array<int, pass_reason_count> seen{};
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        const BuiltMesh a(small_mesh(random, 2 + static_cast<int>(random.below(30)))),
            b(small_mesh(random, 2 + static_cast<int>(random.below(30))));
        Pose pose = random_pose(random);
        pose.translation += Vec3(i % 3, 0, 0.2);
        const std::size_t kind =
            random.below(static_cast<std::uint32_t>(all_volume_kinds().size()));
        const Asked asked = nearest_query(
            a, b, kind, pose, i % 2 == 0 ? DistanceOrder::nearest : DistanceOrder::depth_first);
        const DistanceSteps steps =
            distance_steps(asked.a, a.mesh, asked.b, b.mesh, asked.header, asked.frame);
        const Outcomes outcomes = outcomes_of(asked.header, asked.frame);
        const Attribution worth =
            attribute(asked.header, asked.frame, tested_pairs(steps, asked.frame, outcomes));
        std::map<std::uint32_t, PassReason> reasons;
        for (const PassedPair& pair : worth.passed) reasons[pair.test] = pair.reason;
        EXPECT_TRUE(worth.wrongly_rejected.empty());
        EXPECT_EQ(steps.answer, asked.frame.nearest->distance);
        ASSERT_EQ(steps.bounds.size(), asked.frame.steps.volumes.size());
        for (std::size_t s = 0; s < steps.bounds.size(); ++s) {
            const Step& step = asked.frame.steps.volumes[s];
            double least = HUGE_VAL;
            std::uint64_t as_near = 0, nearly = 0;
            for (const std::uint32_t x : triangles_of(asked.a, step.nodes.a))
                for (const std::uint32_t y : triangles_of(asked.b, step.nodes.b)) {
                    const double apart =
                        triangle_distance(corners(a.mesh, x),
                                          transform_corners(pose, corners(b.mesh, y)))
                            .distance;
                    least = std::min(least, apart);
                    as_near += apart <= steps.answer;
                    nearly += apart <= steps.answer + 1e-14;
                }
            EXPECT_LE(steps.bounds[s], least);
            EXPECT_GE(steps.nearest[s], as_near);
            EXPECT_LE(steps.nearest[s], nearly);
            // Neither triangles nor bounds contradict the verdict on the volumes.
            if (steps.exact[s] == Contact::disjoint) {
                EXPECT_GT(steps.gaps[s], 0);
                EXPECT_GT(least, steps.answer + steps.gaps[s] - 1e-12);
            }
            if (steps.exact[s] == Contact::overlapping && steps.answer > 0) {
                EXPECT_LT(steps.bounds[s], steps.answer);
            }
            // What was left out was not nearer than the answer.
            if (is_rejection(step.stage)) {
                EXPECT_GE(steps.bounds[s], steps.answer);
            }
            if (is_rejection(step.stage)) {
                EXPECT_FALSE(reasons.contains(static_cast<std::uint32_t>(s)));
                continue;
            }
            const PassReason reason = reasons.at(static_cast<std::uint32_t>(s));
            EXPECT_EQ(reason == PassReason::triangles_meet, steps.nearest[s] > 0);
            EXPECT_EQ(reason == PassReason::early,
                      steps.nearest[s] == 0 && steps.bounds[s] > steps.answer);
            ++seen[static_cast<std::size_t>(reason)];
        }
    }
    for (const PassReason reason : {PassReason::weak_test, PassReason::loose_fit,
                                    PassReason::triangles_meet, PassReason::early})
        EXPECT_GT(seen[static_cast<std::size_t>(reason)], 20) << pass_reason_names[reason];
    // Of flat volumes that graze each other, no proof may be found.
    EXPECT_LT(20 * seen[static_cast<std::size_t>(PassReason::unjudged)],
              seen[static_cast<std::size_t>(PassReason::loose_fit)]);
}

TEST(DistanceSteps, TheVerdictOnBallsIsTheirDistance) {
    Random random(7);
    std::array<int, 2> seen{};
    for (int i = 0; i < 20; ++i) {
        const BuiltMesh a(small_mesh(random, 20)), b(small_mesh(random, 20));
        Pose pose = random_pose(random);
        pose.translation += Vec3(1.5, 0, 0);
        const auto kinds = all_volume_kinds();
        const auto kind = static_cast<std::size_t>(
            std::find(kinds.begin(), kinds.end(), VolumeKind::ball) - kinds.begin());
        const Asked asked = nearest_query(a, b, kind, pose, DistanceOrder::depth_first);
        const DistanceSteps steps =
            distance_steps(asked.a, a.mesh, asked.b, b.mesh, asked.header, asked.frame);
        for (std::size_t s = 0; s < steps.exact.size(); ++s) {
            const IndexPair nodes = asked.frame.steps.volumes[s].nodes;
            const Ball &of_a = std::get<Hierarchy<Ball>>(asked.a).volumes[nodes.a],
                       &of_b = std::get<Hierarchy<Ball>>(asked.b).volumes[nodes.b];
            const Vec3 apart = transform_point(pose, of_b.center) - of_a.center;
            const double distance = std::sqrt(squared_norm(apart)) - of_a.radius - of_b.radius;
            if (std::abs(distance - steps.answer) < 1e-6 || steps.answer == 0) continue;
            const bool is_near = distance < steps.answer;
            EXPECT_EQ(steps.exact[s], is_near ? Contact::overlapping : Contact::disjoint);
            ++seen[is_near ? 1 : 0];
        }
    }
    for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(DistanceSteps, WithinATolerance) {
    Random random(6);
    const BuiltMesh a(small_mesh(random, 20)), b(small_mesh(random, 20));
    const Pose pose = random_pose(random);
    TraceHeader header;
    header.kind = QueryKind::within;
    header.tolerance = 0.2;
    QueryTrace frame;
    StepRecorder recorder;
    frame.b_to_a = pose;
    frame.found = within(a.hierarchies[0], a.mesh, b.hierarchies[0], b.mesh, pose, header.tolerance,
                         DescentRule::radius, recorder);
    frame.steps = std::move(recorder.steps);
    ASSERT_FALSE(frame.found.pairs.empty());
    const DistanceSteps steps =
        distance_steps(a.hierarchies[0], a.mesh, b.hierarchies[0], b.mesh, header, frame);
    EXPECT_EQ(steps.answer, 0.2);
    // All pairs are below the roots.
    EXPECT_EQ(steps.nearest[0], frame.found.pairs.size());
}

}  // namespace
}  // namespace scb
