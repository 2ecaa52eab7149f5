#include "core/explain/overlap_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scb/overlap.h"
#include "tests/core/overlap/overlap_checks.h"
#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/core/overlap/scb2_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many_steps = unless_sanitized(100000, 2000);
// All axes of two boxes decide in some pair.
constexpr int many_boxes = std::max(many_steps, 20000);

/// Steps of one pair, after the checks that hold for every one.
template <class V>
OverlapSteps checked_steps(const V& a, const V& b, const Pose& b_to_a,
                           const OverlapOptions& options) {
    const Placement placed = placement(b_to_a, reach(a), reach(b));
    const OverlapSteps steps = overlap_steps(a, b, placed, options);
    const Stage stage = overlap(a, b, b_to_a, options);
    EXPECT_EQ(stage_name(steps.stage()), stage_name(stage)) << overlap_test_name(options.test);
    for (const OverlapStep& step : steps.steps)
        EXPECT_TRUE(std::isfinite(step.left) && std::isfinite(step.right)) << step.formula;
    return steps;
}

/// A step separates where its reaches leave more than `margin`, as far as rounding lets one tell;
/// its slack is the rest, and so are the difference of its sides and the sum of its terms.
void expect_consistent(const OverlapStep& step, const Vec3& c, double margin, double rounding) {
    EXPECT_NEAR(squared_norm(step.direction), 1, 1e-12) << step.formula;
    const double left_over = dot(step.direction, c) - step.reach_a - step.reach_b,
                 rest = left_over - margin;
    EXPECT_NEAR(rest, step.slack, rounding) << step.formula;
    EXPECT_NEAR(std::abs(step.left - step.right), std::abs(left_over), rounding) << step.formula;
    double sum = 0;
    for (const StepTerm& term : step.terms) sum += term.value;
    EXPECT_NEAR(sum, left_over, rounding) << step.formula;
    EXPECT_TRUE(std::abs(rest) <= rounding || step.separates == (rest > 0)) << step.formula;
}

Obb random_wide_box(Random& random) {
    const Pose pose = random_pose(random);
    Obb box{pose.translation, pose.rotation, Vec3::Zero()};
    for (int i = 0; i < 3; ++i)
        box.half[i] = random.below(8) == 0 ? 0 : log_uniform(random, 1e-2, 1);
    return box;
}

class StepsOfTest : public testing::TestWithParam<OverlapTest> {};

TEST_P(StepsOfTest, EndAtTheStageThatTheTestReturns) {
    Random random(17);
    std::array<int, stage_count> ended{};
    int skipped = 0;
    for (int i = 0; i < many_steps; ++i) {
        const auto& family =
            scb_pair_families[static_cast<std::size_t>(i) % scb_pair_families.size()];
        const VolumePair<Scb> pair = i % 4 == 3 ? random_scb_pair(random)
                                     : i % 4 == 2
                                         ? VolumePair<Scb>(touching_scb_pair(random, family, 1))
                                         : VolumePair<Scb>(random_scb_pair(random, family));
        const double threshold = i % 3 == 0 ? 0.7 : random.uniform();
        const OverlapSteps steps =
            checked_steps(pair.a, pair.b, pair.b_to_a, {GetParam(), threshold});
        ++ended[static_cast<std::size_t>(steps.stage())];
        for (const OverlapStep& step : steps.steps) skipped += !step.skipped.empty();
    }
    for (const Stage stage : stages_of(GetParam()))
        EXPECT_GT(ended[static_cast<std::size_t>(stage)], 0) << stage_name(stage);
    EXPECT_EQ(skipped > 0, GetParam() != OverlapTest::symmetric);
}

// A picture draws the reaches: they must be the reaches that the test compares.
TEST_P(StepsOfTest, HaveTheSlackThatTheirReachesLeave) {
    Random random(18);
    int cylinders = 0;
    for (int i = 0; i < many_steps / 10; ++i) {
        const ScbPair pair = random_scb_pair(
            random, scb_pair_families[static_cast<std::size_t>(i) % scb_pair_families.size()]);
        const OverlapSteps steps = checked_steps(pair.a, pair.b, pair.b_to_a, {GetParam(), 0.7});
        const Vec3 c = transform_point(pair.b_to_a, pair.b.c) - pair.a.c;
        const double sine = cross(pair.a.n, transform_direction(pair.b_to_a, pair.b.n)).norm();
        for (const OverlapStep& step : steps.steps) {
            // A step of `extents` that is not made says nothing.
            const bool made = step.skipped.empty() || step.line > 0;
            if (made) expect_consistent(step, c, steps.margin, 1e-11);
            // The cylinder's is the radius of its ball, times the sine of the angle to the axis.
            const bool of_a = step.stage == Stage::cylinder_slab,
                       of_b = step.stage == Stage::slab_cylinder;
            cylinders += of_a || of_b;
            ASSERT_EQ(step.terms.size(), of_a || of_b ? 4u : 3u) << step.formula;
            EXPECT_NEAR(step.effective_radius,
                        of_a   ? pair.a.r * sine
                        : of_b ? pair.b.r * sine
                               : 0,
                        2e-7)
                << step.formula;
        }
    }
    EXPECT_EQ(cylinders > 0, GetParam() != OverlapTest::extents);
}

// The symbols that a picture sums up, by the values that they have.
TEST_P(StepsOfTest, HaveTermsThatAreWhatTheyAreCalled) {
    Random random(19);
    for (int i = 0; i < many_steps / 10; ++i) {
        const ScbPair pair = random_scb_pair(
            random, scb_pair_families[static_cast<std::size_t>(i) % scb_pair_families.size()]);
        const OverlapSteps steps = checked_steps(pair.a, pair.b, pair.b_to_a, {GetParam(), 0.7});
        const Vec3 c = transform_point(pair.b_to_a, pair.b.c) - pair.a.c,
                   n = transform_direction(pair.b_to_a, pair.b.n);
        const double cosine = dot(pair.a.n, n), sine = cross(pair.a.n, n).norm();
        const std::map<std::string, double> values = {{"d0", dot(pair.a.n, c)},
                                                      {"d1", -dot(n, c)},
                                                      {"e0", pair.a.e},
                                                      {"f0", pair.a.f},
                                                      {"e1", pair.b.e},
                                                      {"f1", pair.b.f},
                                                      {"r0", pair.a.r},
                                                      {"r1", pair.b.r},
                                                      {"e0·cα", pair.a.e * cosine},
                                                      {"f0·cα", pair.a.f * cosine},
                                                      {"e1·cα", pair.b.e * cosine},
                                                      {"f1·cα", pair.b.f * cosine},
                                                      {"r0·sα", pair.a.r * sine},
                                                      {"r1·sα", pair.b.r * sine},
                                                      {"‖c1′‖", std::sqrt(dot(c, c))}};
        for (const OverlapStep& step : steps.steps)
            for (const StepTerm& term : step.terms) {
                const bool less = term.name.starts_with("−"), more = term.name.starts_with("+");
                const std::string name = term.name.substr(less ? 3 : more ? 1 : 0);
                EXPECT_EQ(less || more || term.of == StepTerm::Of::distance, true) << term.name;
                if (name.starts_with("ρ")) continue;
                ASSERT_TRUE(values.contains(name)) << name;
                EXPECT_NEAR(term.value, (less ? -1 : 1) * values.at(name), 2e-7) << term.name;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(All, StepsOfTest,
                         testing::ValuesIn(all_overlap_tests().begin(), all_overlap_tests().end()),
                         [](const auto& tested) {
                             return std::string(overlap_test_name(tested.param));
                         });

TEST(Steps, OfBallsEndAtTheStageThatTheTestReturns) {
    Random random(19);
    int rejected_pairs = 0;
    for (int i = 0; i < many_steps; ++i) {
        const Ball a{random_point(random), random.uniform()};
        Ball b{random_point(random), random.uniform()};
        const Pose pose = random_pose(random);
        // Half of them touch, as far as numbers can.
        if (i % 2 == 0)
            b.center = transform_point(
                inverse(pose), Vec3(a.center + (a.radius + b.radius) * random_unit_vector(random)));
        const OverlapSteps steps = checked_steps(a, b, pose, {});
        ASSERT_EQ(steps.steps.size(), 1u);
        const Vec3 c = transform_point(pose, b.center) - a.center;
        expect_consistent(steps.steps[0], c, steps.margin, 1e-14);
        rejected_pairs += steps.stage() != Stage::overlapping;
    }
    EXPECT_GT(rejected_pairs, many_steps / 20);
}

TEST(Steps, OfBoxesEndAtTheStageThatTheTestReturns) {
    Random random(20);
    std::array<int, stage_count> ended{};
    for (int i = 0; i < many_boxes; ++i) {
        const Obb a = random_wide_box(random), b = random_wide_box(random);
        Pose pose = random_pose(random);
        if (i % 5 == 0) pose.rotation = (a.axes * b.axes.transpose()).eval();  // parallel edges
        const OverlapSteps steps = checked_steps(a, b, pose, {});
        ASSERT_EQ(steps.steps.size(), 15u);
        ++ended[static_cast<std::size_t>(steps.stage())];
        const Vec3 c = transform_point(pose, b.center) - a.center;
        for (std::size_t k = 0; k < 15; ++k) {
            // The test leaves the margin along the product of two edges, which is not a unit
            // vector.
            const auto edge_a = static_cast<Eigen::Index>(k < 6 ? 0 : (k - 6) / 3),
                       edge_b = static_cast<Eigen::Index>(k < 6 ? 0 : (k - 6) % 3);
            const double length = k < 6 ? 1
                                        : cross(Vec3(a.axes.col(edge_a)),
                                                transform_direction(pose, Vec3(b.axes.col(edge_b))))
                                              .norm();
            const OverlapStep& step = steps.steps[k];
            EXPECT_EQ(step.skipped.empty(), length > 1e-9 || step.separates) << step.formula;
            if (length > 1e-9) expect_consistent(step, c, steps.margin / length, 1e-14 / length);
        }
    }
    for (const Stage stage : obb_stages())
        EXPECT_GT(ended[static_cast<std::size_t>(stage)], 0) << stage_name(stage);
}

TEST(Steps, OfTwoSlabsEndAtTheStageThatTheTestReturns) {
    Random random(21);
    std::array<int, stage_count> ended{};
    for (int i = 0; i < many_boxes; ++i) {
        const Scb2PairFamily& family =
            scb2_pair_families[static_cast<std::size_t>(i) % scb2_pair_families.size()];
        const VolumePair<Scb2> p = random_scb2_pair(random, family);
        const OverlapSteps steps = checked_steps(p.a, p.b, p.b_to_a, {});
        ASSERT_EQ(steps.steps.size(), 7u);
        ++ended[static_cast<std::size_t>(steps.stage())];
        const Vec3 c = transform_point(p.b_to_a, p.b.c) - p.a.c;
        const Vec3 long_b = transform_direction(p.b_to_a, long_axis(p.b));
        const double sine = cross(long_axis(p.a), long_b).norm();
        for (const OverlapStep& step : steps.steps) {
            const bool of_product = step.stage == Stage::long_axes;
            EXPECT_EQ(step.skipped.empty(), !of_product || sine > 1e-9 || step.separates)
                << step.formula;
            const double length = of_product ? sine : 1;
            if (length > 1e-8) expect_consistent(step, c, steps.margin / length, 1e-13 / length);
        }
    }
    for (const Stage stage : scb2_stages())
        EXPECT_GT(ended[static_cast<std::size_t>(stage)], 0) << stage_name(stage);
}

TEST(Steps, OfTwoSlabsNameTheSecondOne) {
    Scb2 a{Vec3::Zero(), 3, {Slab{Vec3::UnitZ(), 1, -1}, Slab{Vec3::UnitX(), 0.5, -0.25}}}, b = a;
    b.c = Vec3(1, 0.5, 0.5);
    const OverlapSteps steps = checked_steps(a, b, Pose{}, {});
    ASSERT_EQ(steps.stage(), Stage::second_slab_a);
    const OverlapStep& step = steps.steps[2];
    EXPECT_EQ(step.formula, "d0″ − e0″ > ρ1(−n0″)");
    ASSERT_EQ(step.terms.size(), 3u);
    EXPECT_EQ(step.terms[0].name, "d0″");
    EXPECT_EQ(step.terms[1].name, "−e0″");
    EXPECT_EQ(step.terms[2].name, "−ρ1(−n0″)");
    EXPECT_DOUBLE_EQ(step.reach_a, 0.5);
    EXPECT_DOUBLE_EQ(step.reach_b, 0.25);
    EXPECT_NEAR(step.slack, 0.25, 1e-12);
    EXPECT_EQ(steps.steps[6].skipped, "the long axes are parallel");
    b.c = Vec3::Zero();
    EXPECT_EQ(checked_steps(a, b, Pose{}, {}).steps[5].skipped, "the centers coincide");
}

// The product of the long axes of nearly parallel needles is tiny, and yet a direction.
TEST(Steps, OfNearlyParallelNeedlesThatTheProductSeparatesHaveItsDirection) {
    const Scb2 needle{
        Vec3::Zero(), 1, {Slab{Vec3::UnitZ(), 0.01, -0.01}, Slab{Vec3::UnitY(), 0.01, -0.01}}};
    const Vec3 across = Vec3(0, 1, 1) / std::sqrt(2);
    Pose pose{Mat3::Identity(), 0.5 * across};
    // A rotation about it, up to the square of the angle.
    const Vec3 turned = 1e-10 * cross(across, Vec3::UnitX());
    pose.rotation.col(0) += turned;
    pose.rotation.row(0) -= turned.transpose();
    const OverlapStep step = checked_steps(needle, needle, pose, {}).steps[6];
    ASSERT_EQ(step.stage, Stage::long_axes);
    ASSERT_TRUE(step.separates);
    EXPECT_EQ(step.skipped, "");
    EXPECT_NEAR(dot(step.direction, across), 1, 1e-5);
    EXPECT_NEAR(step.left, 0.5, 1e-5);
    EXPECT_GT(step.left, step.right);
}

const OverlapStep& step_at(const OverlapSteps& steps, int line, std::size_t which = 0) {
    for (const OverlapStep& step : steps.steps)
        if (step.line == line && which-- == 0) return step;
    throw std::runtime_error("no such line");
}

TEST(Steps, OfThePrintedTestKeepItsErrors) {
    const Scb a = whole_ball_at({0, 0, 0}, 2), b = slab_at({0, 0, 1}, 0.5, Vec3::UnitZ(), 0.5, 0.1);
    const OverlapSteps printed = checked_steps(a, b, Pose{}, {OverlapTest::printed, 0.7}),
                       corrected = checked_steps(a, b, Pose{}, {OverlapTest::corrected, 0.7});
    EXPECT_EQ(step_at(printed, 8, 1).formula, "d1 − f1 < −r1");
    EXPECT_EQ(step_at(printed, 8, 1).error, "as printed: r1, where it must be r0");
    EXPECT_NEAR(step_at(printed, 8, 1).slack, 0.6, 1e-9);
    EXPECT_EQ(printed.decisive(), 4u);
    EXPECT_EQ(step_at(corrected, 8, 1).formula, "d1 − f1 < −r0");
    EXPECT_NEAR(step_at(corrected, 8, 1).slack, -0.9, 1e-9);
    EXPECT_EQ(step_at(printed, 20).formula, "d1 + f0·cα − e1 > r0·sα");
    EXPECT_EQ(step_at(printed, 20).error,
              "as printed: the call of line 23, which never rejects here");
    for (const OverlapStep& step : corrected.steps) EXPECT_EQ(step.error, "");
    EXPECT_EQ(step_at(corrected, 20).formula, "d1 + e0·cα − f1 < −r0·sα");
    EXPECT_EQ(corrected.decisive(), std::nullopt);
}

// The same case with both normals this way and that, and B on both sides: all eight calls.
TEST(Steps, NameTheCallsOfFigure8) {
    struct Case {
        double side, turn;
        int line;
        const char *first, *second;
    };
    for (const Case& c : {Case{1, -1, 12, "d0 + e1·cα − e0 > r1·sα", "d1 + e0·cα − e1 > r0·sα"},
                          Case{-1, -1, 15, "d0 + f1·cα − f0 < −r1·sα", "d1 + f0·cα − f1 < −r0·sα"},
                          Case{1, 1, 19, "d0 + f1·cα − e0 > r1·sα", "d1 + e0·cα − f1 < −r0·sα"},
                          Case{-1, 1, 22, "d0 + e1·cα − f0 < −r1·sα", "d1 + f0·cα − e1 > r0·sα"}}) {
        const Scb a = slab_at({0, 0, 0}, 1, Vec3::UnitZ(), 0.25, -0.25),
                  b = slab_at({0.1, 0, c.side * 0.6}, 1, c.turn * Vec3::UnitZ(), 0.25, -0.25);
        const OverlapSteps steps = checked_steps(a, b, Pose{}, {OverlapTest::corrected, 0.7});
        EXPECT_EQ(step_at(steps, c.line).formula, c.first);
        EXPECT_EQ(step_at(steps, c.line + 1).formula, c.second);
        EXPECT_NEAR(step_at(steps, c.line).slack, 0.1, 1e-6);
        EXPECT_NEAR(step_at(steps, c.line + 1).slack, 0.1, 1e-6);
        EXPECT_EQ(steps.decisive(), 5u);
    }
}

TEST(Steps, SayWhyTheyAreNotMade) {
    const Vec3 tilted(0.6, 0, 0.8);
    const Scb a = slab_at({0, 0, 0}, 1, Vec3::UnitZ(), 0.01, -0.01),
              b = slab_at({0, 0, 0.4}, 0.5, tilted, 0.01, -0.01);
    const OverlapSteps steps = checked_steps(a, b, Pose{}, {OverlapTest::corrected, 0.9});
    EXPECT_EQ(steps.stage(), Stage::overlapping);
    EXPECT_EQ(step_at(steps, 19).skipped, "|n0·n1| = 0.8 is not above a = 0.9");
    EXPECT_TRUE(step_at(steps, 19).separates);
    EXPECT_TRUE(
        step_at(checked_steps(a, b, Pose{}, {OverlapTest::corrected, 0.7}), 19).skipped.empty());
}

}  // namespace
}  // namespace scb
