#include "core/overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/collide.h"
#include "tests/core/volume_pairs.h"

namespace scb {
namespace {

constexpr std::array sound_tests = {OverlapTest::line8, OverlapTest::corrected,
                                    OverlapTest::symmetric, OverlapTest::extents};
constexpr std::array slab_cylinder_tests = {OverlapTest::line8, OverlapTest::corrected,
                                            OverlapTest::symmetric};

Stage stage_of_pair(const VolumePair<Scb>& pair, OverlapTest test, double threshold = 0.7) {
    return overlap(pair.a, pair.b, pair.b_to_a, {test, threshold});
}

bool rejected(const VolumePair<Scb>& pair, OverlapTest test, double threshold = 0.7) {
    return stage_of_pair(pair, test, threshold) != Stage::overlapping;
}

// Both in one frame, and then each in a frame of its own.
template <class V>
void expect_stage(const V& a, const V& b, Stage stage, OverlapTest test = OverlapTest::corrected,
                  double threshold = 0.7) {
    Random random(11);
    const OverlapOptions options{test, threshold};
    EXPECT_EQ(stage_name(overlap(a, b, Pose{}, options)), stage_name(stage))
        << overlap_test_name(test);
    for (int i = 0; i < 10; ++i) {
        const Pose world_a = random_pose(random), world_b = random_pose(random);
        EXPECT_EQ(stage_name(overlap(moved(inverse(world_a), a), moved(inverse(world_b), b),
                                     relative_pose(world_a, world_b), options)),
                  stage_name(stage))
            << overlap_test_name(test) << ", moved";
    }
}

Scb slab_at(const Vec3& c, double r, const Vec3& n, double e, double f) { return {c, r, n, e, f}; }
Scb whole_ball_at(const Vec3& c, double r) { return {c, r, Vec3::UnitZ(), r, -r}; }

const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();

// ------------------------------------------------------------------ stage by stage, by hand

TEST(Overlap, OfTwoBallsEndsAtTheirDistance) {
    expect_stage(Ball{Vec3(0, 0, 0), 1}, Ball{Vec3(0, 3, 4), 3.9}, Stage::ball_ball);
    expect_stage(Ball{Vec3(0, 0, 0), 1}, Ball{Vec3(0, 3, 4), 4.1}, Stage::overlapping);
    expect_stage(Ball{Vec3(1, 1, 1), 0}, Ball{Vec3(1, 1, 1), 0}, Stage::overlapping);
}

TEST(Overlap, OfScbsEndsWhereTheBallsAreApart) {
    for (const OverlapTest test : all_overlap_tests())
        for (const Vec3& c : {Vec3(2.01, 0, 0), Vec3(0, 0, -2.01)}) {
            expect_stage(slab_at({0, 0, 0}, 1, z, 0.25, -0.25), whole_ball_at(c, 1),
                         Stage::ball_ball, test);
            expect_stage(whole_ball_at(c, 1), slab_at({0, 0, 0}, 1, x, 0.25, -0.25),
                         Stage::ball_ball, test);
        }
}

TEST(Overlap, OfScbsEndsWhereABallIsAboveOrBelowASlab) {
    const Scb slab = slab_at({0, 0, 0}, 1, z, 0.25, -0.5);
    for (const Scb& ball : {whole_ball_at({0.3, 0, 1.3}, 1), whole_ball_at({0.3, 0, -1.55}, 1)}) {
        for (const OverlapTest test : all_overlap_tests()) {
            if (test == OverlapTest::extents) continue;
            expect_stage(slab, ball, Stage::slab_ball, test);
            expect_stage(ball, slab, Stage::ball_slab, test);
        }
        expect_stage(slab, ball, Stage::slab_a, OverlapTest::extents);
        Scb turned = ball;
        turned.n = x;
        expect_stage(turned, slab, Stage::slab_b, OverlapTest::extents);
    }
    for (const OverlapTest test : sound_tests) {
        expect_stage(slab, whole_ball_at({0.3, 0, 1.2}, 1), Stage::overlapping, test);
        expect_stage(slab, whole_ball_at({0.3, 0, -1.45}, 1), Stage::overlapping, test);
    }
}

// A large ball with a slab high above its center, a small ball in it: its own radius must not be
// taken for the other's, as line 8 does in print.
TEST(Overlap, MeasuresTheBallOfAAgainstTheSlabOfBByTheRadiusOfA) {
    const Scb a = whole_ball_at({0, 0, 0}, 2), b = slab_at({0, 0, -0.5}, 1, z, 1, 0.9);
    // A point of both.
    EXPECT_TRUE(contains(a, Vec3(0, 0, 0.45)) && contains(b, Vec3(0, 0, 0.45)));
    const Scb low = slab_at({0, 0, 1}, 0.5, z, 0.5, 0.1);
    EXPECT_TRUE(contains(a, Vec3(0, 0, 1.2)) && contains(low, Vec3(0, 0, 1.2)));
    for (const OverlapTest test : sound_tests) {
        expect_stage(a, b, Stage::overlapping, test);
        expect_stage(a, low, Stage::overlapping, test);
    }
    expect_stage(a, low, Stage::ball_slab, OverlapTest::printed);
}

TEST(Overlap, OfScbsEndsWhereTwoParallelSlabsAreApart) {
    const Scb a = slab_at({0, 0, 0}, 1, z, 0.25, -0.25);
    for (const double side : {-1.0, 1.0})
        for (const bool opposed : {false, true}) {
            const Scb b = slab_at({0.1, 0, side * 0.6}, 1, opposed ? Vec3(-z) : z, 0.25, -0.25);
            const Scb near = slab_at({0.1, 0, side * 0.45}, 1, b.n, 0.25, -0.25);
            for (const OverlapTest test : slab_cylinder_tests) {
                expect_stage(a, b, Stage::slab_cylinder, test);
                expect_stage(a, near, Stage::overlapping, test);
            }
            expect_stage(a, b, Stage::slab_cylinder, OverlapTest::printed);
            expect_stage(a, b, Stage::slab_a, OverlapTest::extents);
            expect_stage(a, near, Stage::overlapping, OverlapTest::extents);
        }
}

// A is small and tilted against the large flat B: the cylinder about A stays clear of B's slab,
// though its ball does not, and though B's cylinder reaches A's slab.
TEST(Overlap, OfScbsEndsWhereATiltedCylinderIsOffASlab) {
    const double cosine = 12.0 / 13, sine = 5.0 / 13;
    for (const double side : {-1.0, 1.0})
        for (const double sign : {-1.0, 1.0}) {
            const bool opposed = sign < 0;
            const Scb a =
                slab_at({0, 0, side * 0.25}, 0.2, sign * Vec3(sine, 0, cosine), 0.05, -0.05);
            const Scb b = slab_at({0, 0, 0}, 1, z, 0.1, -0.1);
            expect_stage(a, b, Stage::cylinder_slab, OverlapTest::corrected);
            expect_stage(a, b, Stage::cylinder_slab, OverlapTest::symmetric);
            expect_stage(a, b, Stage::slab_b, OverlapTest::extents);
            // Lines 20 and 23 as printed never reject.
            expect_stage(a, b, opposed ? Stage::cylinder_slab : Stage::overlapping,
                         OverlapTest::line8);
            const Scb nearer =
                slab_at({0, 0, side * 0.21}, 0.2, sign * Vec3(sine, 0, cosine), 0.05, -0.05);
            for (const OverlapTest test : sound_tests)
                expect_stage(nearer, b, Stage::overlapping, test);
        }
}

TEST(Overlap, ByExtentsEndsWhereTheLineOfCentersSeparates) {
    const double sine = std::sqrt(0.75);
    const Scb a = slab_at({0, 0, 0}, 1, Vec3(0.5, sine, 0), 0.2, -1);
    const auto b = [&](double at) { return slab_at({at, 0, 0}, 1, Vec3(-0.5, sine, 0), 0.2, -1); };
    const double reach = 2 * (0.2 * 0.5 + std::sqrt(0.96 * 0.75));
    expect_stage(a, b(reach + 0.01), Stage::center_line, OverlapTest::extents);
    expect_stage(a, b(reach - 0.01), Stage::overlapping, OverlapTest::extents);
    for (const OverlapTest test : slab_cylinder_tests)
        expect_stage(a, b(reach + 0.01), Stage::overlapping, test);
}

Stage axis(Stage first, int i) { return static_cast<Stage>(static_cast<int>(first) + i); }

TEST(Overlap, OfBoxesEndsAtEachFaceNormal) {
    for (int i = 0; i < 3; ++i)
        for (const double side : {-1.0, 1.0}) {
            const Obb a{Vec3(0, 0, 0), Mat3::Identity(), Vec3(1, 2, 3)};
            Obb b{Vec3(0, 0, 0), Mat3::Identity(), Vec3(0.5, 0.25, 0.125)};
            b.center[i] = side * (a.half[i] + b.half[i] + 0.01);
            expect_stage(a, b, axis(Stage::axis_a0, i));
            b.center[i] = side * (a.half[i] + b.half[i] - 0.01);
            expect_stage(a, b, Stage::overlapping);

            // A's corner points at the middle of B's face.
            const Vec3 d = Vec3(1, 1, 1) / std::sqrt(3.0), u = Vec3(1, -1, 0) / std::sqrt(2.0);
            Obb corner{Vec3(0, 0, 0), Mat3::Identity(), Vec3(1, 1, 1)};
            Mat3 from, to;
            from << d, u, cross(d, u);
            to << Vec3::Unit(i), Vec3::Unit((i + 1) % 3), Vec3::Unit((i + 2) % 3);
            corner.axes = to * from.transpose();
            const Obb cube{Vec3(0, 0, 0), Mat3::Identity(), Vec3(1, 1, 1)};
            corner.center[i] = side * (1 + std::sqrt(3.0) + 0.01);
            expect_stage(corner, cube, axis(Stage::axis_b0, i));
            corner.center[i] = side * (1 + std::sqrt(3.0) - 0.01);
            expect_stage(corner, cube, Stage::overlapping);
        }
}

TEST(Overlap, OfBoxesEndsAtEachPairOfEdges) {
    const double h = std::sqrt(0.5);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (const double side : {-1.0, 1.0}) {
                // A's edge i runs along x, B's edge j along y, and both point at each other.
                Obb a{Vec3(0, 0, 0), Mat3::Identity(), Vec3(1, 1, 1)}, b = a;
                a.axes.col(i) = Vec3(1, 0, 0);
                a.axes.col((i + 1) % 3) = Vec3(0, h, h);
                a.axes.col((i + 2) % 3) = Vec3(0, -h, h);
                b.axes.col(j) = Vec3(0, 1, 0);
                b.axes.col((j + 1) % 3) = Vec3(h, 0, h);
                b.axes.col((j + 2) % 3) = Vec3(h, 0, -h);
                ASSERT_TRUE(is_well_formed(a) && is_well_formed(b));
                b.center = side * (4 * h + 0.01) * z;
                expect_stage(a, b, axis(Stage::axis_a0_b0, 3 * i + j));
                b.center = side * (4 * h - 0.01) * z;
                expect_stage(a, b, Stage::overlapping);
            }
}

// ------------------------------------------------------------------------------- closed sets

// The farthest point of a slab cut ball in a direction.
Vec3 support(const Scb& s, const Vec3& d) {
    const double h = s.r * dot(s.n, d);
    if (s.f <= h && h <= s.e) return s.c + s.r * d;
    const double k = h > s.e ? s.e : s.f;
    const Vec3 along = d - dot(s.n, d) * s.n;
    const double length = along.norm();
    const Vec3 center = s.c + k * s.n;
    if (length < 1e-8) return center;
    return center + std::sqrt(std::max(0.0, (s.r - k) * (s.r + k))) / length * along;
}

TEST(ClosedScbs, OverlapWhereTheyTouchByHand) {
    const auto expect_touching = [](const Scb& a, const Scb& b) {
        for (const OverlapTest test : sound_tests) {
            expect_stage(a, b, Stage::overlapping, test, 0.0);
            expect_stage(b, a, Stage::overlapping, test, 0.0);
            expect_stage(flipped(a), b, Stage::overlapping, test);
            expect_stage(a, flipped(b), Stage::overlapping, test);
        }
    };
    const Scb plate = slab_at({0, 0, 0}, 1, z, 0.25, -0.25);
    expect_touching(whole_ball_at({0, 0, 0}, 1), whole_ball_at({0, 3, 4}, 4));  // balls
    expect_touching(plate, slab_at({2, 0, 0}, 1, z, 0.25, -0.25));              // zones
    expect_touching(plate, whole_ball_at({0.5, 0, 1.25}, 1));                   // plane, ball
    expect_touching(plate, whole_ball_at({0.5, 0, -1.25}, 1));                  //
    expect_touching(plate, slab_at({0.5, 0.5, 0.5}, 1, z, 0.25, -0.25));        // planes
    expect_touching(plate, slab_at({0.5, 0.5, -0.5}, 1, -z, 0.25, -0.25));      //
    expect_touching(plate, slab_at({0.5, 0, 1.25}, 1, x, 0.5, -0.25));          // plane, zone
    expect_touching(slab_at({0, 0, 0}, 5, z, 3, -1), slab_at({8, 0, 6}, 5, z, 0, -3));  // rims
    expect_touching(slab_at({0, 0, 0}, 1, z, 0, 0), slab_at({2, 0, 0}, 1, z, 0, 0));    // discs
    expect_touching(whole_ball_at({0, 0, 0}, 0), whole_ball_at({0, 0, 0}, 0));          // points
    expect_touching(slab_at({0, 0, 0}, 1, z, 1, 1), slab_at({0, 0, 2}, 1, z, -1, -1));
    expect_touching(slab_at({0, 0, 0}, 1, z, 0.5, 0.25), slab_at({0, 0, 0}, 1, z, 0.25, -1));
}

// B is made to touch A in one point and to lie on the other side of a plane there.
TEST(ClosedScbs, OverlapWhereTheyTouchAnywhere) {
    Random random(12);
    for (int i = 0; i < 20000; ++i) {
        VolumePair<Scb> pair = random_scb_pair(random);
        Scb b = moved(pair.b_to_a, pair.b);
        Vec3 d = random_unit_vector(random);
        const std::uint32_t kind = random.below(4);
        if (kind == 0) d = pair.a.n;
        if (kind == 1) d = -b.n;
        b.c += support(pair.a, d) - support(b, -d);
        const double away = random.below(4) == 0 ? 1000 : 1;
        const Pose world_a = random_pose(random, away), world_b = random_pose(random, away);
        pair.b_to_a = relative_pose(world_a, world_b);
        pair.a = moved(inverse(world_a), pair.a);
        pair.b = moved(inverse(world_b), b);
        for (const OverlapTest test : sound_tests)
            for (const double threshold : {0.0, 0.7})
                ASSERT_EQ(stage_name(stage_of_pair(pair, test, threshold)), "overlapping")
                    << overlap_test_name(test) << ", pair " << i;
    }
}

TEST(ClosedBallsAndBoxes, OverlapWhereTheyTouch) {
    Random random(13);
    for (int i = 0; i < 20000; ++i) {
        const Pose world_a = random_pose(random, 3), world_b = random_pose(random, 3);
        const Pose pose = relative_pose(world_a, world_b);
        const Vec3 d = random_unit_vector(random);
        const Ball a{random_point(random), random.uniform(0, 1)};
        Ball b{{}, random.uniform(0, 1)};
        b.center = a.center + (a.radius + b.radius) * d;
        ASSERT_EQ(overlap(moved(inverse(world_a), a), moved(inverse(world_b), b), pose),
                  Stage::overlapping);

        // Supporting corners: a face, an edge or a corner of A on one of B.
        Obb p{random_point(random), random_rotation(random),
              random_point(random).cwiseAbs().cwiseMax(0.05)},
            q = p;
        if (random.below(3) != 0) q.axes = random_rotation(random);
        q.half = random_point(random).cwiseAbs();
        if (random.below(4) == 0) q.half[random.below(3)] = 0;
        Vec3 axis = d;
        const int u = static_cast<int>(random.below(3)), v = static_cast<int>(random.below(3));
        const std::uint32_t kind = random.below(4);
        if (kind == 0) axis = p.axes.col(u);
        if (kind == 1) axis = q.axes.col(u);
        if (kind == 2) axis = cross(Vec3(p.axes.col(u)), Vec3(q.axes.col(v)));
        if (axis.norm() < 0.1) continue;
        axis.normalize();
        const auto corner = [](const Obb& box, const Vec3& direction) {
            Vec3 c = box.center;
            for (int k = 0; k < 3; ++k)
                c += (dot(Vec3(box.axes.col(k)), direction) > 0 ? 1 : -1) * box.half[k] *
                     box.axes.col(k);
            return c;
        };
        q.center += corner(p, axis) - corner(q, -axis);
        ASSERT_EQ(stage_name(overlap(moved(inverse(world_a), p), moved(inverse(world_b), q), pose)),
                  "overlapping");
    }
}

TEST(Placement, LeavesAMarginOfSome1eMinus14OfTheLengths) {
    Random random(24);
    for (int i = 0; i < 1000; ++i) {
        Pose pose = random_pose(random, 5);
        const double a = random.uniform(0, 9), b = random.uniform(0, 9);
        const double lengths = a + b + pose.translation.norm();
        EXPECT_GT(placement(pose, a, b).margin, 7e-15 * lengths);
        EXPECT_LT(placement(pose, a, b).margin, 2e-14 * lengths);
        // A pose that is just not refused stretches B.
        pose.rotation.col(1) *= 1 + 4e-10;
        EXPECT_GT(placement(pose, a, b).margin, 4e-10 * b);
    }
}

TEST(Overlap, RejectsWhatIsApartByMuchLessThanItsSize) {
    for (const double gap : {1e-12, 1e-6}) {
        const Scb a = slab_at({0, 0, 0}, 1, z, 0.25, -0.25);
        const Scb b = slab_at({0.1, 0, 0.5 + gap}, 1, z, 0.25, -0.25);
        // The bound of the sine of parallel normals is 6e-8, so a gap below it is not seen.
        for (const OverlapTest test : slab_cylinder_tests)
            expect_stage(a, b, gap > 1e-7 ? Stage::slab_cylinder : Stage::overlapping, test);
        expect_stage(Ball{{0, 0, 0}, 1}, Ball{{2 + gap, 0, 0}, 1}, Stage::ball_ball);
        expect_stage(whole_ball_at({0, 0, 1.25 + gap}, 1), slab_at({0, 0, 0}, 1, z, 0.25, -0.25),
                     Stage::ball_slab, OverlapTest::symmetric);
        Obb p{{0, 0, 0}, Mat3::Identity(), {1, 1, 1}}, q = p;
        q.center[0] = 2 + gap;
        expect_stage(p, q, Stage::axis_a0);
    }
}

// -------------------------------------------------------------------------------- invariance

constexpr int pairs_tried = 40000;

// Whether rounding cannot turn the verdict.
bool is_decided(const VolumePair<Scb>& p, OverlapTest test, double threshold = 0.7) {
    constexpr double tiny = 1e-9;
    return rejected({grown(p.a, tiny), grown(p.b, tiny), p.b_to_a}, test, threshold) ==
           rejected({grown(p.a, -tiny), grown(p.b, -tiny), p.b_to_a}, test, threshold);
}

VolumePair<Scb> exchanged(const VolumePair<Scb>& p) { return {p.b, p.a, inverse(p.b_to_a)}; }

// Calls `use` with random pairs of which the test's verdict is not a matter of rounding.
template <class Use>
void for_decided_pairs(OverlapTest test, Use use) {
    Random random(14);
    int decided = 0, overlapping = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> pair = random_scb_pair(random);
        if (!is_decided(pair, test)) continue;
        ++decided;
        overlapping += !rejected(pair, test);
        use(pair);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(decided, pairs_tried * 99 / 100);
    EXPECT_GT(overlapping, pairs_tried / 4);
    EXPECT_LT(overlapping, pairs_tried * 3 / 4);
}

TEST(OverlapVerdict, OfSymmetricAndExtentsStaysWhenAAndBAreExchanged) {
    for (const OverlapTest test : {OverlapTest::symmetric, OverlapTest::extents})
        for_decided_pairs(test, [&](const VolumePair<Scb>& pair) {
            EXPECT_EQ(rejected(exchanged(pair), test), rejected(pair, test));
        });
}

TEST(OverlapVerdict, OfCorrectedSymmetricAndExtentsStaysWhenASlabIsFlipped) {
    for (const OverlapTest test :
         {OverlapTest::corrected, OverlapTest::symmetric, OverlapTest::extents})
        for_decided_pairs(test, [&](const VolumePair<Scb>& p) {
            // Signs change without rounding, so the stage stays too.
            const auto stage = stage_name(stage_of_pair(p, test));
            const Pose& pose = p.b_to_a;
            EXPECT_EQ(stage_name(stage_of_pair({flipped(p.a), p.b, pose}, test)), stage);
            EXPECT_EQ(stage_name(stage_of_pair({p.a, flipped(p.b), pose}, test)), stage);
            EXPECT_EQ(stage_name(stage_of_pair({flipped(p.a), flipped(p.b), pose}, test)), stage);
        });
}

TEST(OverlapVerdict, OfEveryTestStaysWhenBothAreMovedRigidly) {
    for (const OverlapTest test : all_overlap_tests()) {
        Random motions(15);
        for_decided_pairs(test, [&](const VolumePair<Scb>& p) {
            const Pose m = random_pose(motions, 10), frame = random_pose(motions, 10);
            EXPECT_EQ(rejected({moved(m, p.a), p.b, compose(m, p.b_to_a)}, test),
                      rejected(p, test));
            EXPECT_EQ(rejected({p.a, moved(frame, p.b), compose(p.b_to_a, inverse(frame))}, test),
                      rejected(p, test));
        });
    }
}

TEST(OverlapVerdict, OfEveryTestStaysWhenBothAreScaledByAPowerOfTwo) {
    Random random(16);
    for (int i = 0; i < pairs_tried / 4; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        const double factor = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
        const VolumePair<Scb> q{scaled(p.a, factor),
                                scaled(p.b, factor),
                                {p.b_to_a.rotation, factor * p.b_to_a.translation}};
        for (const OverlapTest test : all_overlap_tests())
            ASSERT_EQ(stage_name(stage_of_pair(q, test)), stage_name(stage_of_pair(p, test)))
                << overlap_test_name(test) << " at " << factor;
    }
}

// How many of the random pairs get another verdict from `change`.
template <class Verdict, class Change>
int verdicts_changed(Verdict verdict, Change change) {
    Random random(17);
    int changed = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        changed += verdict(p) != verdict(change(p));
    }
    return changed;
}

VolumePair<Scb> with_b_flipped(const VolumePair<Scb>& p) { return {p.a, flipped(p.b), p.b_to_a}; }

// Each of the two errors of Figure 8 alone is caught by flipping, which the corrected form stands;
// exchanging it does not stand, since the sign of d0 picks the sides of both slabs.
TEST(OverlapVerdict, OfEitherErrorOfFigure8ChangesWhenASlabIsFlipped) {
    const auto verdict = []<Figure8Errata errata>() {
        return [](const VolumePair<Scb>& p) {
            const Placement placed = placement(p.b_to_a, reach(p.a), reach(p.b));
            return overlap_figure8<errata>(p.a, p.b, placed, 0.7) != Stage::overlapping;
        };
    };
    const auto line_8 = verdict.operator()<Figure8Errata{true, false}>();
    const auto lines_20_23 = verdict.operator()<Figure8Errata{false, true}>();
    const auto both = verdict.operator()<Figure8Errata{true, true}>();
    const auto none = verdict.operator()<Figure8Errata{}>();
    EXPECT_GT(verdicts_changed(line_8, with_b_flipped), 100);
    EXPECT_GT(verdicts_changed(lines_20_23, with_b_flipped), 100);
    EXPECT_GT(verdicts_changed(both, with_b_flipped), 100);
    EXPECT_EQ(verdicts_changed(none, with_b_flipped), 0);

    EXPECT_GT(verdicts_changed(line_8, exchanged), 100);
    EXPECT_GT(verdicts_changed(both, exchanged), 100);
    EXPECT_GT(verdicts_changed(none, exchanged), 0);
}

TEST(OverlapVerdict, OfSymmetricRejectsWhateverCorrectedRejectsAndMore) {
    for (const double threshold : {0.0, 0.3, 0.7, 1.0}) {
        Random random(18);
        int corrected = 0, symmetric = 0;
        for (int i = 0; i < pairs_tried; ++i) {
            const VolumePair<Scb> p = random_scb_pair(random);
            corrected += rejected(p, OverlapTest::corrected, threshold);
            symmetric += rejected(p, OverlapTest::symmetric);
            if (!is_decided(p, OverlapTest::symmetric)) continue;
            if (rejected(p, OverlapTest::corrected, threshold)) {
                ASSERT_TRUE(rejected(p, OverlapTest::symmetric)) << i;
            }
        }
        EXPECT_GT(symmetric, corrected);
    }
}

TEST(OverlapVerdict, OfFigure8RejectsMoreTheLowerTheThreshold) {
    Random random(19);
    constexpr std::array thresholds = {0.0, 0.3, 0.7, 0.95, 1.0};
    std::array<int, thresholds.size()> count{};
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        bool before = true;
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            const Stage stage = stage_of_pair(p, OverlapTest::corrected, thresholds[k]);
            const bool now = stage != Stage::overlapping;
            count[k] += now;
            ASSERT_LE(now, before);
            before = now;
            if (thresholds[k] == 1.0) {
                EXPECT_NE(stage, Stage::slab_cylinder);
                EXPECT_NE(stage, Stage::cylinder_slab);
            }
        }
    }
    for (std::size_t k = 1; k < thresholds.size(); ++k) EXPECT_LT(count[k], count[k - 1]) << k;
}

TEST(Figure8, MakesCylinderTestsOnlyBeyondTheThreshold) {
    const double cosine = 0.8, sine = 0.6;
    const Scb a = slab_at({0, 0, 0}, 0.1, z, 0.01, -0.01);
    for (const double sign : {-1.0, 1.0}) {
        const Scb b = slab_at({0, 0, 0.0995}, 0.1, sign * Vec3(sine, 0, cosine), 0.01, -0.01);
        expect_stage(a, b, Stage::slab_cylinder, OverlapTest::corrected, 0.79);
        expect_stage(a, b, Stage::overlapping, OverlapTest::corrected, 0.81);
    }
}

// -------------------------------------------------------------------------- exact extents

TEST(ReachAtCosine, IsTheExtentAndNeverLess) {
    Random random(20);
    for (int i = 0; i < 100000; ++i) {
        const Scb s = random_scb(random, random_unit_vector(random));
        Vec3 d = random_unit_vector(random);
        const std::uint32_t kind = random.below(4);
        if (kind == 0) d = s.n;
        if (kind == 1) d = (s.n + 1e-7 * d).normalized();
        if (random.below(2) == 0) d = -d;
        const double exact = extent(s, d), found = reach_at_cosine(s, dot(s.n, d), 1 + 0x1p-47);
        ASSERT_GE(found, exact - 1e-15);
        // The bound of the squared sine is 2^-47 above 1, which is 9e-8 of the radius.
        ASSERT_LE(found, exact + 1e-7 * s.r);
        if (kind > 1) {
            ASSERT_NEAR(found, exact, 1e-11);
        }
    }
}

TEST(OverlapByExtents, EndsAtTheFirstOfItsAxesThatSeparatesTheExtents) {
    Random random(21);
    std::set<Stage> seen;
    int undecided = 0;
    for (int i = 0; i < pairs_tried; ++i) {
        const VolumePair<Scb> p = random_scb_pair(random);
        const Scb b = moved(p.b_to_a, p.b);
        const Vec3 c = b.c - p.a.c;
        const auto gap = [&](const Vec3& d) { return dot(d, c) - extent(p.a, d) - extent(b, -d); };
        const auto gap_both = [&](const Vec3& n) { return std::max(gap(n), gap(-n)); };
        const std::array<double, 4> gaps = {c.norm() - p.a.r - b.r, gap_both(p.a.n), gap_both(b.n),
                                            gap(c.normalized())};
        if (std::any_of(gaps.begin(), gaps.end(), [](double g) { return std::abs(g) < 1e-6; })) {
            ++undecided;
            continue;
        }
        Stage stage = Stage::overlapping;
        for (std::size_t k = gaps.size(); k-- > 0;)
            if (gaps[k] > 0) stage = stages_of(OverlapTest::extents)[k];
        ASSERT_EQ(stage_name(stage_of_pair(p, OverlapTest::extents)), stage_name(stage)) << i;
        seen.insert(stage);
    }
    EXPECT_EQ(seen.size(), 5u);
    EXPECT_LT(undecided, pairs_tried / 1000);
}

// --------------------------------------------------------------------------- special cases

TEST(Overlap, OfScbsWithOneCenterIsDecidedByTheirSlabs) {
    const Vec3 c(0.5, -0.25, 2);
    for (const OverlapTest test : sound_tests) {
        expect_stage(slab_at(c, 1, z, 0.1, -0.1), slab_at(c, 2, x, 0.1, -0.1), Stage::overlapping,
                     test);
        expect_stage(whole_ball_at(c, 1), whole_ball_at(c, 1), Stage::overlapping, test);
        expect_stage(whole_ball_at(c, 0), whole_ball_at(c, 0), Stage::overlapping, test);
    }
    // Caps on either side of the center that they share.
    const Scb upper = slab_at(c, 1, z, 0.6, 0.5), lower = slab_at(c, 1, z, -0.5, -0.6);
    for (const Scb& a : {upper, flipped(upper)})
        for (const Scb& b : {lower, flipped(lower)}) {
            expect_stage(a, b, Stage::slab_cylinder, OverlapTest::symmetric);
            expect_stage(b, a, Stage::slab_cylinder, OverlapTest::symmetric);
            expect_stage(a, b, Stage::slab_a, OverlapTest::extents);
            expect_stage(b, a, Stage::slab_a, OverlapTest::extents);
        }
}

TEST(Overlap, TakesPointsForScbsOfRadiusZero) {
    const Scb s = slab_at({0, 0, 0}, 1, z, 0.25, -0.5);
    const auto point = [](const Vec3& p) { return slab_at(p, 0, x, 0, 0); };
    for (const OverlapTest test : sound_tests) {
        for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.25), Vec3(0, 0, -0.5), Vec3(1, 0, 0)})
            expect_stage(s, point(p), Stage::overlapping, test);
        const bool extents = test == OverlapTest::extents;
        expect_stage(s, point({1.001, 0, 0}), Stage::ball_ball, test);
        expect_stage(s, point({0, 0, 0.251}), extents ? Stage::slab_a : Stage::slab_ball, test);
        expect_stage(point({0, 0, -0.501}), s, extents ? Stage::slab_b : Stage::ball_slab, test);
    }
}

TEST(Overlap, TakesDiscsForScbsOfThicknessZero) {
    const Scb disc = slab_at({0, 0, 0}, 1, z, 0, 0);
    for (const OverlapTest test : sound_tests) {
        expect_stage(disc, slab_at({0.5, 0, 0.001}, 1, z, 0, 0),
                     test == OverlapTest::extents ? Stage::slab_a : Stage::slab_cylinder, test);
        expect_stage(disc, slab_at({0.5, 0, 0}, 1, z, 0, 0), Stage::overlapping, test);
        expect_stage(disc, slab_at({0.5, 0, 0}, 1, x, 0, 0), Stage::overlapping, test);
    }
}

// A slab that leaves the center out: the two caps face each other though the centers do not.
TEST(Overlap, HoldsForSlabsThatLeaveTheCenterOut) {
    const Scb cap = slab_at({0, 0, 0}, 1, z, 1, 0.75);
    for (const OverlapTest test : {OverlapTest::symmetric, OverlapTest::extents}) {
        const Stage stage = test == OverlapTest::extents ? Stage::slab_a : Stage::slab_cylinder;
        expect_stage(cap, slab_at({0, 0, 0.5}, 1, z, 0, -1), stage, test);
        expect_stage(cap, slab_at({0, 0, 0.5}, 1, z, 0.5, -1), Stage::overlapping, test);
    }
    for (const OverlapTest test : sound_tests) {
        // Crossed: B's center is below A's slab, its slab above its center.
        expect_stage(cap, slab_at({0, 0, -0.5}, 1.5, z, 1.5, 1.3), Stage::overlapping, test);
        expect_stage(cap, slab_at({0, 0, 2}, 1, -z, 1, 0.75), Stage::overlapping, test);
    }
}

// -------------------------------------------------------------------------- boxes, exactly

/// Whether a segment meets the box whose sides are `half + slack`, by clipping.
bool segment_meets_box(Vec3 from, Vec3 to, const Obb& box, double slack) {
    from -= box.center;
    to -= box.center;
    double first = 0, last = 1;
    for (int k = 0; k < 3; ++k) {
        const double a = dot(Vec3(box.axes.col(k)), from), b = dot(Vec3(box.axes.col(k)), to);
        const double half = box.half[k] + slack;
        for (const double sign : {-1.0, 1.0}) {
            // sign * (a + t (b - a)) <= half
            const double start = sign * a - half, rise = sign * (b - a);
            if (std::abs(rise) < 1e-13) {
                if (start > 0) return false;
            } else if (rise > 0) {
                last = std::min(last, -start / rise);
            } else {
                first = std::max(first, -start / rise);
            }
        }
    }
    return first <= last;
}

/// Two boxes overlap where and only where an edge of one meets the other: a corner of what they
/// have in common is on an edge of one of them.
bool edges_meet(const Obb& a, const Obb& b, double slack) {
    const auto edges_of_meet = [slack](const Obb& p, const Obb& q) {
        for (int k = 0; k < 3; ++k)
            for (const double u : {-1.0, 1.0})
                for (const double v : {-1.0, 1.0}) {
                    const Vec3 along = p.half[k] * p.axes.col(k);
                    const Vec3 middle = p.center +
                                        u * p.half[(k + 1) % 3] * p.axes.col((k + 1) % 3) +
                                        v * p.half[(k + 2) % 3] * p.axes.col((k + 2) % 3);
                    if (segment_meets_box(middle - along, middle + along, q, slack)) return true;
                }
        return false;
    };
    return edges_of_meet(a, b) || edges_of_meet(b, a);
}

TEST(OverlapOfBoxes, AgreesWithClippingTheirEdges) {
    Random random(22);
#ifdef SCB_SANITIZED
    constexpr int count = 10000;
#else
    constexpr int count = 100000;
#endif
    int apart = 0, overlapping = 0;
    std::set<Stage> seen;
    for (int i = 0; i < count; ++i) {
        const auto random_half = [&] {
            Vec3 half = random_point(random).cwiseAbs();
            if (random.below(3) == 0) half[random.below(3)] = 0;
            if (random.below(10) == 0) half[random.below(3)] = 0;
            if (random.below(4) == 0) half[random.below(3)] *= 4;
            return half;
        };
        const Obb a{random_point(random), random_rotation(random), random_half()};
        Obb b{{}, random_rotation(random), random_half()};
        const std::uint32_t kind = random.below(4);
        if (kind == 0) b.axes = a.axes;
        if (kind == 1) {  // one axis in common
            const double angle = random.uniform(0, 6);
            Mat3 turn;
            turn << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0,
                1;
            b.axes = a.axes * turn;
        }
        const Vec3 d = random_unit_vector(random);
        b.center = a.center + random.uniform(0.3, 1.1) * (extent(a, d) + extent(b, d)) * d;
        const Pose pose = random_pose(random);
        const Obb in_own_frame = moved(inverse(pose), b);
        if (edges_meet(a, b, 1e-12)) {
            ++overlapping;
            Obb larger_a = a, larger_b = in_own_frame;
            larger_a.half.array() += 1e-9;
            larger_b.half.array() += 1e-9;
            ASSERT_EQ(stage_name(overlap(larger_a, larger_b, pose)), "overlapping") << i;
        } else if (!edges_meet(a, b, 1e-7)) {
            ++apart;
            const Stage stage = overlap(a, in_own_frame, pose);
            ASSERT_NE(stage_name(stage), "overlapping") << i;
            seen.insert(stage);
        }
    }
    EXPECT_GT(apart, count / 4);
    EXPECT_GT(overlapping, count / 4);
    EXPECT_EQ(seen.size(), 15u);
}

// ------------------------------------------------------------------------------------ names

TEST(Names, OfTestsStagesAndRulesAreReadBack) {
    std::set<std::string_view> names;
    for (const OverlapTest test : all_overlap_tests()) {
        EXPECT_EQ(overlap_test_of(overlap_test_name(test)), test);
        names.insert(overlap_test_name(test));
    }
    EXPECT_EQ(names.size(), all_overlap_tests().size());
    EXPECT_FALSE(overlap_test_of("exact"));
    EXPECT_FALSE(overlap_test_of(""));

    names.clear();
    for (std::size_t s = 0; s < stage_count; ++s) {
        const Stage stage = static_cast<Stage>(s);
        EXPECT_EQ(stage_of(stage_name(stage)), stage);
        names.insert(stage_name(stage));
    }
    EXPECT_EQ(names.size(), stage_count);
    EXPECT_FALSE(stage_of("ball_ball"));

    for (const DescentRule rule : all_descent_rules())
        EXPECT_EQ(descent_rule_of(descent_rule_name(rule)), rule);
    EXPECT_EQ(all_descent_rules().size(), 4u);
    EXPECT_FALSE(descent_rule_of("Radius"));
}

TEST(Stages, OfEveryTestAreListedInTheOrderInWhichTheyAreTried) {
    for (const OverlapTest test : all_overlap_tests()) {
        const auto stages = stages_of(test);
        EXPECT_TRUE(std::is_sorted(stages.begin(), stages.end()));
        EXPECT_EQ(stages.front(), Stage::ball_ball);
    }
    EXPECT_EQ(ball_stages().size(), 1u);
    EXPECT_EQ(obb_stages().size(), 15u);
    EXPECT_EQ(obb_stages().front(), Stage::axis_a0);
    EXPECT_EQ(obb_stages().back(), Stage::axis_a2_b2);
}

}  // namespace
}  // namespace scb
