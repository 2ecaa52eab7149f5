#include "core/distance/distance_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/core/distance/proof_scene.h"

namespace scb {
namespace {

/// A scene whose cut has many ends, with its certificate.
struct TamperedScene {
    ProofScene scene;
    BruteForce brute;
    DistanceCertificate certificate;

    explicit TamperedScene(std::uint64_t seed)
        : scene(random_soup(seed, 40, 0.1), random_soup(seed + 1, 40, 0.1),
                {Mat3::Identity(), {0.3, 0.1, 0.2}}),
          brute(scene),
          certificate(make_certificate(scene.tree_a(), scene.tree_b(), scene.pose, brute.closest)) {
    }
};

TEST(DistanceCheck, ProvesNothingUntrueOnceTampered) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    using Tamper = std::function<void(DistanceCertificate&, Random&)>;
    const auto some_direction = [](DistanceCertificate& c, Random& random) -> Vec3& {
        return c.directions[random.below(static_cast<std::uint32_t>(c.directions.size()))];
    };
    const auto some_step = [](DistanceCertificate& c, Random& random) -> CutStep& {
        return c.cut[random.below(static_cast<std::uint32_t>(c.cut.size()))];
    };
    struct Kind {
        const char* name;
        bool is_fault;  // always; otherwise a fault or wide bounds
        Tamper tamper;
    };
    const std::vector<Kind> kinds = {
        {"the last pair left out", true,
         [](auto& c, auto&) {
             c.cut.pop_back();
             c.directions.pop_back();
         }},
        {"a pair left out", true,
         [](auto& c, auto& random) {
             const auto at = random.below(static_cast<std::uint32_t>(c.directions.size()));
             std::uint32_t ends = 0;
             for (std::size_t i = 0; i < c.cut.size(); ++i)
                 if (c.cut[i] == CutStep::end && ends++ == at) {
                     c.cut.erase(c.cut.begin() + static_cast<std::ptrdiff_t>(i));
                     break;
                 }
             c.directions.erase(c.directions.begin() + at);
         }},
        {"truncated", true,
         [](auto& c, auto& random) {
             c.cut.resize(1 + random.below(static_cast<std::uint32_t>(c.cut.size() - 1)));
         }},
        {"steps after the end", true,
         [](auto& c, auto&) {
             c.cut.push_back(CutStep::end);
             c.directions.push_back(Vec3::UnitX());
         }},
        {"divisions after the end", true,
         [](auto& c, auto&) { c.cut.push_back(CutStep::divide_a); }},
        {"a direction too many", true,
         [](auto& c, auto&) { c.directions.push_back(Vec3::UnitX()); }},
        {"a direction too few", true, [](auto& c, auto&) { c.directions.pop_back(); }},
        {"an unknown step", true,
         [&](auto& c, auto& random) { some_step(c, random) = static_cast<CutStep>(77); }},
        {"leaves divided", true, [](auto& c, auto&) { c.cut.assign(1000, CutStep::divide_a); }},
        {"a step changed", true,
         [&](auto& c, auto& random) {
             CutStep& step = some_step(c, random);
             step = step == CutStep::end ? CutStep::divide_b : CutStep::end;
         }},
        {"a triangle out of range", true, [](auto& c, auto&) { c.on_a.triangle = 40; }},
        {"a triangle far out of range", true, [](auto& c, auto&) { c.on_b.triangle = ~0u; }},
        {"a corner out of range", true, [](auto& c, auto&) { c.on_b.corner = 3; }},
        {"a point outside", true, [](auto& c, auto&) { c.on_a.to_next = -1e-9; }},
        {"a point beyond", true, [](auto& c, auto&) { c.on_a.to_after = 0.7; }},
        {"a point that is none", true, [&](auto& c, auto&) { c.on_b.to_after = nan; }},
        {"another triangle", false,
         [](auto& c, auto&) { c.on_a.triangle = (c.on_a.triangle + 7) % 40; }},
        {"another point", false, [](auto& c, auto&) { c.on_a.to_next = 0.5 - c.on_a.to_next; }},
        {"a direction flipped", false,
         [&](auto& c, auto& random) { some_direction(c, random) *= -1; }},
        {"a direction that is none", false,
         [&](auto& c, auto& random) { some_direction(c, random)[1] = nan; }},
        {"an infinite direction", false,
         [&](auto& c, auto& random) { some_direction(c, random)[0] = HUGE_VAL; }},
        {"no direction", false,
         [&](auto& c, auto& random) { some_direction(c, random).setZero(); }},
        {"directions in another order", false,
         [](auto& c, auto&) { std::reverse(c.directions.begin(), c.directions.end()); }},
        {"the roots alone", false,
         [](auto& c, auto&) {
             c.cut = {CutStep::end};
             c.directions = {Vec3::UnitX()};
         }},
        {"no cut", false,
         [](auto& c, auto&) {
             c.cut.clear();
             c.directions.clear();
         }},
    };
    int tampered_with = 0;
    for (int i = 0; i < unless_sanitized(40, 4); ++i) {
        const TamperedScene honest(static_cast<std::uint64_t>(2 * i));
        if (honest.brute.rounded == 0) continue;
        ++tampered_with;
        ASSERT_GT(honest.certificate.directions.size(), 2u);
        ASSERT_TRUE(certifies(honest.scene.check(honest.certificate), honest.brute.rounded));
        Random random(static_cast<std::uint64_t>(i));
        for (const Kind& kind : kinds) {
            SCOPED_TRACE(kind.name);
            DistanceCertificate tampered = honest.certificate;
            kind.tamper(tampered, random);
            const ProvenDistance proven = honest.scene.check(tampered);
            EXPECT_TRUE(holds(proven, honest.brute.distance));
            EXPECT_FALSE(certifies(proven, honest.brute.rounded));
            EXPECT_EQ(!proven.fault.empty(), kind.is_fault) << proven.fault;
        }
    }
    EXPECT_GT(tampered_with, unless_sanitized(10, 0));
}

TEST(DistanceCheck, ProvesNothingUntrueByRandomLists) {
    const TamperedScene honest(4);
    Random random(29);
    int proofs = 0;
    for (int i = 0; i < 20'000 / unless_sanitized(1, 10); ++i) {
        ProofScene scene = honest.scene;
        const std::uint32_t spoiled = random.below(4);
        for (std::uint32_t k = 0; k < spoiled; ++k) {
            Topology& tree = random.below(2) == 0 ? scene.of_a : scene.of_b;
            TopologyNode& node =
                tree.nodes[random.below(static_cast<std::uint32_t>(tree.nodes.size()))];
            const std::array<std::uint32_t*, 3> numbers = {&node.first, &node.count, &node.left};
            *numbers[random.below(3)] =
                random.below(8) == 0 ? static_cast<std::uint32_t>(random.next()) : random.below(80);
        }
        // A list that ends where all pairs have ended, most of the time.
        DistanceCertificate certificate = honest.certificate;
        certificate.cut.clear();
        certificate.directions.clear();
        for (std::uint32_t open = 1; open > 0 && certificate.cut.size() < 200;) {
            const std::uint32_t kind = random.below(100);
            const CutStep step = kind < 53   ? CutStep::end
                                 : kind < 76 ? CutStep::divide_a
                                             : CutStep::divide_b;
            certificate.cut.push_back(step);
            if (step == CutStep::end) certificate.directions.push_back(random_point(random));
            open = step == CutStep::end ? open - 1 : open + 1;
        }
        const ProvenDistance proven = scene.check(certificate);
        proofs += proven.fault.empty();
        ASSERT_TRUE(holds(proven, honest.brute.distance)) << i;
    }
    EXPECT_GT(proofs, 1000 / unless_sanitized(1, 10));
}

TEST(DistanceCheck, HoldsForDirectionsOfAnyLength) {
    for (const double scale : {1e-300, 1e-12, 3.0, 1e290}) {
        TamperedScene honest(8);
        for (Vec3& direction : honest.certificate.directions) direction *= scale / direction.norm();
        EXPECT_TRUE(certifies(honest.scene.check(honest.certificate), honest.brute.rounded));
    }
}

TEST(DistanceCheck, IsForItsMeshesAndItsPose) {
    for (int i = 0; i < unless_sanitized(40, 4); ++i) {
        const TamperedScene honest(static_cast<std::uint64_t>(2 * i));
        if (honest.brute.rounded == 0) continue;
        ProofScene moved = honest.scene;
        moved.pose.translation += Vec3(0.1, -0.2, 0.1);
        Random random(static_cast<std::uint64_t>(i));
        ProofScene turned = honest.scene;
        turned.pose.rotation = random_rotation(random);
        const ProofScene swapped(honest.scene.b, honest.scene.a, inverse(honest.scene.pose)),
            other(honest.scene.a, random_soup(99, 40, 0.1), honest.scene.pose),
            smaller(honest.scene.a, random_soup(99, 9, 0.1), honest.scene.pose);
        for (const ProofScene& scene : {moved, turned, swapped, other, smaller}) {
            const BruteForce brute(scene);
            const ProvenDistance proven = scene.check(honest.certificate);
            EXPECT_TRUE(holds(proven, brute.distance));
            EXPECT_FALSE(certifies(proven, brute.rounded));
        }
        ProofScene scaled = honest.scene;
        scaled.pose.rotation *= 2;  // not rigid, but a map of B's corners
        EXPECT_TRUE(holds(scaled.check(honest.certificate), BruteForce(scaled).distance));
        scaled.pose.rotation(1, 1) = std::numeric_limits<double>::quiet_NaN();
        EXPECT_NE(scaled.check(honest.certificate).fault, "");
    }
}

/// Divides all of A's tree, and none of B's nodes.
DistanceCertificate divided_a(const ProofScene& scene) {
    DistanceCertificate certificate;
    std::vector<std::uint32_t> pending = {0};
    while (!pending.empty()) {
        const TopologyNode& node = scene.of_a.nodes[pending.back()];
        pending.pop_back();
        certificate.cut.push_back(node.is_leaf() ? CutStep::end : CutStep::divide_a);
        if (node.is_leaf())
            certificate.directions.push_back(Vec3::UnitX());
        else
            pending.insert(pending.end(), {node.left + 1, node.left});
    }
    return certificate;
}

TEST(DistanceCheck, NeedsChildrenThatMakeUpTheirParents) {
    const TamperedScene honest(4);
    const DistanceCertificate divided = divided_a(honest.scene);
    EXPECT_EQ(honest.scene.check(divided).fault, "");
    for (const TopologyNode& node : honest.scene.of_a.nodes) {
        if (node.is_leaf()) continue;
        ProofScene shifted = honest.scene;
        ++shifted.of_a.nodes[node.left].first;
        ++shifted.of_a.nodes[node.left + 1].first;
        EXPECT_NE(shifted.check(divided).fault, "");
        for (const bool is_right : {false, true})
            for (const std::uint32_t change : {1u, ~0u}) {
                ProofScene scene = honest.scene;
                TopologyNode& child = scene.of_a.nodes[node.left + is_right];
                child.first += change;
                EXPECT_NE(scene.check(divided).fault, "");
                child.first -= change;
                child.count += change;
                EXPECT_NE(scene.check(divided).fault, "");
            }
    }
}

TEST(DistanceCheck, NeedsTreesThatHaveAllTriangles) {
    const TamperedScene honest(4);
    const auto fault = [&](const std::function<void(ProofScene&)>& spoil) {
        ProofScene scene = honest.scene;
        spoil(scene);
        return scene.check(honest.certificate).fault;
    };
    EXPECT_EQ(fault([](auto&) {}), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.order[3] = s.of_a.order[4]; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_b.order[3] = 40; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.order.pop_back(); }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.nodes.clear(); }), "");
    EXPECT_NE(fault([](auto& s) { s.of_b.nodes[0].count = 39; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.nodes[0].left = 79; }), "");
    EXPECT_NE(fault([](auto& s) { s.of_a.nodes[0].left = ~0u; }), "");
    EXPECT_NE(fault([](auto& s) { --s.of_a.nodes[s.of_a.nodes[0].left].count; }), "");
    EXPECT_NE(fault([](auto& s) { ++s.of_b.nodes[s.of_b.nodes[0].left + 1].first; }), "");
    EXPECT_NE(fault([](auto& s) { s.a.triangles.clear(); }), "");
    EXPECT_NE(fault([](auto& s) { s.a.triangles[5][1] = 4000; }), "");
    EXPECT_NE(fault([](auto& s) { s.b.vertices[5][1] = HUGE_VAL; }), "");
    // A node that is its own child: a cut ends with its list.
    ProofScene loop = honest.scene;
    loop.of_a.nodes[1] = loop.of_a.nodes[0];
    loop.of_a.nodes[2] = {40, 0, 0};
    loop.of_a.nodes[0].left = loop.of_a.nodes[1].left = 1;
    DistanceCertificate endless = honest.certificate;
    endless.cut.assign(100'000, CutStep::divide_a);
    EXPECT_NE(loop.check(endless).fault, "");
}

/// Two clouds along a line, whose gap is of the size of rounding, or larger, or an overlap.
TEST(DistanceCheck, ProvesNoGapThatIsWiderThanThePointsAre) {
    Random random(71);
    double worst = 0;
    int positive = 0;
    for (int i = 0; i < 20'000 / unless_sanitized(1, 20); ++i) {
        const Vec3 n = random_unit_vector(random) * std::pow(10, random.uniform(-5, 5));
        const double far = std::pow(10, random.uniform(-3, 6)),
                     gap = std::pow(10, random.uniform(-17, 0)) * far;
        const Vec3 there = far * random_point(random);
        std::vector<Vec3> a, b;
        double of_a = 0, of_b = 0;
        const auto add = [&](std::vector<Vec3>& to, double& most, double height) {
            const Vec3 u = random_point(random), unit = n / n.norm();
            to.push_back(there + far * cross(unit, u) + height * unit);
            most = std::max(most, to.back().cwiseAbs().sum());
        };
        for (int k = 0; k < 6; ++k) add(a, of_a, random.below(2) == 0 ? 0 : -gap);
        for (int k = 0; k < 6; ++k) add(b, of_b, random.below(2) == 0 ? gap : 2 * gap);
        long double exact = HUGE_VALL;
        const auto at = [&](const Vec3& p, int axis) {
            return static_cast<long double>(n[axis]) * static_cast<long double>(p[axis]);
        };
        for (const Vec3& p : a)
            for (const Vec3& q : b)
                exact = std::min(
                    exact, (at(q, 0) - at(p, 0)) + (at(q, 1) - at(p, 1)) + (at(q, 2) - at(p, 2)));
        const auto x = static_cast<long double>(n[0]), y = static_cast<long double>(n[1]),
                   z = static_cast<long double>(n[2]);
        exact /= std::sqrt(x * x + y * y + z * z);
        const double magnitude = of_a + of_b, error = 1e-18 * magnitude;
        for (const double enough : {0.0, static_cast<double>(exact), HUGE_VAL}) {
            const double proven = proven_gap(a, b, n, magnitude, enough);
            ASSERT_LE(proven, std::max(exact, 0.0L) + static_cast<long double>(error)) << i;
            ASSERT_GE(proven, 0);
        }
        positive += exact > 0;
        // To the last bits, if they decide.
        worst = std::max(worst, static_cast<double>(exact) -
                                    proven_gap(a, b, n, magnitude, static_cast<double>(exact)) -
                                    error - 1e-14 * static_cast<double>(exact));
    }
    EXPECT_LE(worst, 0);
    EXPECT_GT(positive, 10'000 / unless_sanitized(1, 20));
}

TEST(DistanceCheck, OfTrianglesThatAreNotTheClosestIsTrueAndWide) {
    std::size_t most_ends = 0;
    for (int i = 0; i < unless_sanitized(100, 5); ++i) {
        const TamperedScene honest(static_cast<std::uint64_t>(2 * i));
        const auto& scene = honest.scene;
        Random random(static_cast<std::uint64_t>(i));
        const IndexPair pair{random.below(40), random.below(40)};
        if (triangle_distance(scene.corners_a(pair.a), scene.corners_b(pair.b)).distance <=
            1.01 * honest.brute.rounded)
            continue;
        const DistanceCertificate certificate =
            make_certificate(scene.tree_a(), scene.tree_b(), scene.pose, pair);
        most_ends = std::max(most_ends, certificate.directions.size());
        const ProvenDistance proven = scene.check(certificate);
        EXPECT_EQ(proven.fault, "");
        EXPECT_TRUE(holds(proven, honest.brute.distance));
        EXPECT_NEAR(proven.lower, honest.brute.rounded, 1e-9);
        EXPECT_FALSE(certifies(proven, honest.brute.rounded));
    }
    // Of 1600 pairs of triangles: one pair that is too near is enough to give up the others.
    EXPECT_LT(most_ends, 400u);
}

}  // namespace
}  // namespace scb
