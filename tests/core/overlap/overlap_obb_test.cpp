#include "core/overlap/overlap_obb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/core/overlap/overlap_checks.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

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
                b.center = side * (4 * h + 0.01) * unit_z;
                expect_stage(a, b, axis(Stage::axis_a0_b0, 3 * i + j));
                b.center = side * (4 * h - 0.01) * unit_z;
                expect_stage(a, b, Stage::overlapping);
            }
}

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

/// Two boxes overlap if and only if an edge of one meets the other: each corner of their
/// intersection is on an edge of one of them.
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
    constexpr int count = unless_sanitized(100000, 10000);
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
        b.center = a.center + random.uniform(0.3, 1.1) * (support(a, d) + support(b, d)) * d;
        const Pose pose = random_pose(random);
        const Obb in_own_frame = placed(b, inverse(pose));
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

}  // namespace
}  // namespace scb
