#include "scenes/shapes/torus_knot.h"

#include <cmath>
#include <limits>

#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

TorusKnot knot_a(int sides, int rings) {
    TorusKnot knot;
    knot.sides = sides;
    knot.rings = rings;
    return knot;
}

TorusKnot knot_b(int sides, int rings) {
    TorusKnot knot = knot_a(sides, rings);
    knot.offset = 0.9;
    return knot;
}

double length(const Vec3& v) { return std::sqrt(squared_norm(v)); }

TEST(TorusKnot, HasTheCountsOfTable2AndIsClosed) {
    for (const auto& [sides, rings, triangles] :
         {std::tuple{12, 147, 3528u}, {14, 245, 6860u}, {16, 343, 10976u}}) {
        const Mesh mesh = torus_knot_mesh(knot_a(sides, rings));
        EXPECT_EQ(mesh.vertices.size(), static_cast<std::size_t>(sides * rings));
        EXPECT_EQ(mesh.triangles.size(), triangles);
        expect_closed(mesh);
        EXPECT_GT(signed_volume6(mesh), 0);
        expect_closed(torus_knot_mesh(knot_b(sides, rings + 10)));
    }
}

TEST(TorusKnot, HasAnOrthonormalFrameWithTheTangentOfTheCurve) {
    for (const TorusKnot& knot : {knot_a(12, 147), knot_b(12, 153)}) {
        for (int i = 0; i < 100; ++i) {
            const double t = i / 100.0, h = 1e-6;
            const KnotFrame frame = knot_frame(knot, t);
            const Vec3 chord = knot_frame(knot, t + h).point - knot_frame(knot, t - h).point;
            EXPECT_LT(length(chord / length(chord) - frame.tangent), 1e-8);
            EXPECT_NEAR(length(frame.normal), 1, 1e-14);
            EXPECT_NEAR(length(frame.binormal), 1, 1e-14);
            EXPECT_NEAR(dot(frame.normal, frame.tangent), 0, 1e-14);
        }
    }
}

TEST(TorusKnot, DoesNotTwistWildly) {
    for (const TorusKnot& knot : {knot_a(12, 147), knot_b(12, 153)})
        for (int i = 0; i < knot.rings; ++i) {
            const Vec3 here = knot_frame(knot, static_cast<double>(i) / knot.rings).normal;
            const Vec3 next = knot_frame(knot, static_cast<double>(i + 1) / knot.rings).normal;
            EXPECT_GT(dot(here, next), 0.9) << "ring " << i;
        }
}

TEST(TorusKnot, StartsTheCompanionAlongTheTorusNormal) {
    const Vec3 a = knot_frame(knot_a(12, 147), 0).point, b = knot_frame(knot_b(12, 147), 0).point;
    EXPECT_LT(length(b - a - Vec3(0.9, 0, 0)), 1e-15);
    for (int i = 0; i < 50; ++i)
        EXPECT_NEAR(length(knot_frame(knot_b(12, 147), i / 50.0).point -
                           knot_frame(knot_a(12, 147), i / 50.0).point),
                    0.9, 1e-14);
}

/// The least distance between points of two curves, leaving out pairs of one curve that are near
/// along it.
double least_distance(const TorusKnot& first, const TorusKnot& second, bool same_curve) {
    constexpr int n = 1500;
    std::vector<Vec3> a, b;
    for (int i = 0; i < n; ++i) {
        a.push_back(knot_frame(first, static_cast<double>(i) / n).point);
        b.push_back(knot_frame(second, static_cast<double>(i) / n).point);
    }
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const int along = std::min(std::abs(i - j), n - std::abs(i - j));
            if (same_curve && along < n / 10) continue;
            least = std::min(least, squared_norm(a[static_cast<std::size_t>(i)] -
                                                 b[static_cast<std::size_t>(j)]));
        }
    return std::sqrt(least);
}

TEST(TorusKnot, KeepsTheTubesOfTheBenchmarkATenthApart) {
    const TorusKnot a = knot_a(12, 147), b = knot_b(12, 153);
    const double gap = least_distance(a, b, false) - 0.8;
    EXPECT_GT(gap, 0.09);
    EXPECT_LT(gap, 0.1001);
    EXPECT_GT(least_distance(a, a, true), 0.8);
}

TEST(TorusKnot, RefusesWhatItCannotMake) {
    const auto refused = [](auto change) {
        TorusKnot knot;
        change(knot);
        return refusal([&] { torus_knot_mesh(knot); });
    };
    expect_in("p is 0;", refused([](TorusKnot& k) { k.p = 0; }));
    expect_in("rings is 2;", refused([](TorusKnot& k) { k.rings = 2; }));
    expect_in("triangles; at most", refused([](TorusKnot& k) { k.rings = k.sides = 4000000; }));
    expect_in("offset is -1;", refused([](TorusKnot& k) { k.offset = -1; }));
    expect_in("tube_radius is inf;", refused([](TorusKnot& k) { k.tube_radius = 1.0 / 0.0; }));
}

}  // namespace
}  // namespace scb::scenes
