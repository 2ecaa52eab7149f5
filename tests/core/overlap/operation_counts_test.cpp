#ifdef __clang__
// The tests evaluate both sides of `|` on purpose; with numbers that count, that is a side effect.
#pragma clang diagnostic ignored "-Wbitwise-instead-of-logical"
#endif

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/analysis/cost_equation.h"
#include "core/overlap/test_functors.h"
#include "tests/core/overlap/counting_scalar.h"
#include "tests/core/overlap/scb2_pairs.h"
#include "tests/core/overlap/volume_pairs.h"

namespace scb {
namespace {

/// The fewest and the most operations, and comparisons, with which a test ended at a stage.
struct Range {
    OperationCounts fewest{1 << 20, 1 << 20, 1 << 20}, most;

    void add(const OperationCounts& c) {
        fewest = {std::min(fewest.operations, c.operations),
                  std::min(fewest.comparisons, c.comparisons),
                  std::min(fewest.square_roots, c.square_roots)};
        most = {std::max(most.operations, c.operations), std::max(most.comparisons, c.comparisons),
                std::max(most.square_roots, c.square_roots)};
    }
};

std::string text(const OperationCounts& c) {
    return std::to_string(c.operations) + " operations, " + std::to_string(c.comparisons) +
           " comparisons, " + std::to_string(c.square_roots) + " square roots";
}

/// Makes the test on many pairs, with numbers that count and with doubles, which must agree.
template <class Draw, class Counting, class Plain>
std::map<Stage, Range> measure(const std::string& name, int pairs, Draw draw,
                               Counting counting_test, Plain plain_test) {
    Random random(31);
    std::map<Stage, Range> ranges;
    for (int i = 0; i < pairs; ++i) {
        const auto pair = draw(random, i);
        const Placement placed = placement(pair.b_to_a, reach(pair.a), reach(pair.b));
        const auto a = counting(pair.a), b = counting(pair.b);
        const auto counting_placed = counting(placed);
        CountingScalar::counts = {};
        const Stage stage = counting_test(a, b, counting_placed);
        ranges[stage].add(CountingScalar::counts);
        EXPECT_EQ(stage_name(stage), stage_name(plain_test(pair.a, pair.b, placed)));
    }
    for (const auto& [stage, range] : ranges)
        testing::Test::RecordProperty(name + " " + std::string(stage_name(stage)),
                                      range.fewest == range.most
                                          ? text(range.most)
                                          : text(range.fewest) + " to " + text(range.most));
    return ranges;
}

template <class Counting, class Plain>
std::map<Stage, Range> measure(const std::string& name, Counting counting_test, Plain plain_test) {
    return measure(
        name, 60000, [](Random& random, int) { return random_scb_pair(random); }, counting_test,
        plain_test);
}

void expect_range(const std::map<Stage, Range>& ranges, Stage stage, const OperationCounts& fewest,
                  const OperationCounts& most) {
    ASSERT_TRUE(ranges.contains(stage)) << stage_name(stage);
    EXPECT_EQ(text(ranges.at(stage).fewest), text(fewest)) << stage_name(stage);
    EXPECT_EQ(text(ranges.at(stage).most), text(most)) << stage_name(stage);
}

/// operation_cost says for each stage what was counted at most.
void expect_costs(const std::map<Stage, Range>& ranges, OverlapTest test) {
    for (const auto& [stage, range] : ranges)
        EXPECT_EQ(static_cast<int>(operation_cost(VolumeKind::scb, {test, 0.7}, stage)),
                  static_cast<int>(range.most.operations))
            << overlap_test_name(test) << " " << stage_name(stage);
}

// Table 1 of the paper: 28, 35, 60, 82 and 99 operations; 1, 3, 5, 9 and 13 comparisons.
//
//   task            paper      here       the difference
//   ball, ball      28   1     29   1     +1 the margin, which is added to a radius
//   slab, ball       7   2      7   2
//   ball, slab      25   2     24   2     -2 d1 is negated, not the three coordinates of c0';
//                                         +1 the margin, which is added to the other radius
//   slab, cylinder  22   4     15/16  5   -9 the distance of the cylinder's top is d0 + k cos, 2
//                                         operations where equations 7 and 8 take 11; +1 the
//                                         margin; +1 the threshold's negative; +1 on one side the
//                                         gap's negative. The comparison more is the cosine's with
//                                         both thresholds at once.
//   cylinder, slab  17   4      7/8   2   -9 the same, here in full; -2 the squared sine is still
//                                         known; +1 the margin; +1 the gap's negative. The two
//                                         comparisons that select the case are not made again.
//   all             99  13     82/84 12
//
// One branch checks that a gap is positive and long enough. Two branches would save three
// operations but cost more, because the first one is hard to predict.
TEST(OperationCounts, OfFigure8AreBelowTable1ByWhatItsFormSaves) {
    const CountingScalar threshold = 0.7;
    const auto ranges = measure(
        "corrected",
        [&](const auto& a, const auto& b, const auto& placed) {
            return overlap_figure8<Figure8Errata{}>(a, b, placed, threshold);
        },
        [](const Scb& a, const Scb& b, const Placement& placed) {
            return overlap_figure8<Figure8Errata{}>(a, b, placed, 0.7);
        });
    expect_range(ranges, Stage::ball_ball, {29, 1, 0}, {29, 1, 0});
    expect_range(ranges, Stage::slab_ball, {36, 3, 0}, {36, 3, 0});
    expect_range(ranges, Stage::ball_slab, {60, 5, 0}, {60, 5, 0});
    expect_range(ranges, Stage::slab_cylinder, {75, 10, 0}, {76, 10, 0});
    expect_range(ranges, Stage::cylinder_slab, {82, 12, 0}, {84, 12, 0});
    expect_range(ranges, Stage::overlapping, {66, 7, 0}, {84, 12, 0});
    expect_costs(ranges, OverlapTest::corrected);
}

// The 84 above; +8 for two middles and two half thicknesses, which could be stored; +1 |cos|; +3
// for the half thicknesses in each of the two gaps; -1 without a threshold: one less than Table 1,
// with four comparisons less.
TEST(OperationCounts, OfSymmetricAreOneBelowTable1AtWorst) {
    const auto ranges = measure(
        "symmetric",
        [](const auto& a, const auto& b, const auto& placed) {
            return overlap_symmetric(a, b, placed);
        },
        [](const Scb& a, const Scb& b, const Placement& placed) {
            return overlap_symmetric(a, b, placed);
        });
    expect_range(ranges, Stage::ball_ball, {29, 1, 0}, {29, 1, 0});
    expect_range(ranges, Stage::slab_ball, {36, 3, 0}, {36, 3, 0});
    expect_range(ranges, Stage::ball_slab, {60, 5, 0}, {60, 5, 0});
    expect_range(ranges, Stage::slab_cylinder, {87, 7, 0}, {87, 7, 0});
    expect_range(ranges, Stage::cylinder_slab, {98, 9, 0}, {98, 9, 0});
    expect_range(ranges, Stage::overlapping, {98, 9, 0}, {98, 9, 0});
    expect_costs(ranges, OverlapTest::symmetric);
}

// At worst one square root for each of the four extents and one for the distance.
TEST(OperationCounts, OfExtentsAreAtMost115WithFiveSquareRoots) {
    const auto ranges = measure(
        "extents",
        [](const auto& a, const auto& b, const auto& placed) {
            return overlap_extents(a, b, placed);
        },
        [](const Scb& a, const Scb& b, const Placement& placed) {
            return overlap_extents(a, b, placed);
        });
    expect_range(ranges, Stage::ball_ball, {29, 1, 0}, {29, 1, 0});
    expect_range(ranges, Stage::slab_a, {59, 6, 0}, {69, 11, 1});
    expect_range(ranges, Stage::slab_b, {67, 10, 0}, {90, 21, 2});
    expect_range(ranges, Stage::center_line, {80, 17, 2}, {115, 33, 5});
    // The fewest depend on how often axis points fall into the other slab, which is rare.
    EXPECT_EQ(text(ranges.at(Stage::overlapping).most), text({115, 33, 5}));
    expect_costs(ranges, OverlapTest::extents);
}

// At worst five square roots for each of the eight extents, and two for lengths.
TEST(OperationCounts, OfTwoSlabs) {
    const auto ranges = measure(
        "scb2", 60000,
        [](Random& random, int i) {
            return random_scb2_pair(
                random,
                scb2_pair_families[static_cast<std::size_t>(i) % scb2_pair_families.size()]);
        },
        [](const auto& a, const auto& b, const auto& placed) { return overlap_scb2(a, b, placed); },
        [](const Scb2& a, const Scb2& b, const Placement& placed) {
            return overlap_scb2(a, b, placed);
        });
    for (const auto& [stage, range] : ranges) {
        // The dearest case of all, signs included, is rare.
        const auto cost = static_cast<int>(operation_cost(VolumeKind::scb2, {}, stage));
        EXPECT_LE(range.most.operations, cost) << stage_name(stage);
        EXPECT_GE(range.most.operations, cost - 2) << stage_name(stage);
        EXPECT_LE(range.most.square_roots, 42) << stage_name(stage);
    }
}

}  // namespace
}  // namespace scb
