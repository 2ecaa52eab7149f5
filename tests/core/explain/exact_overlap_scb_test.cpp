#include "core/explain/exact_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many_scbs = unless_sanitized(112000, 2000);

// Narrower than what counts as touching by default: what the search can tell.
constexpr double strict = 1e-13;

Scb ball(const Vec3& c, double r) { return {c, r, Vec3::UnitZ(), r, -r}; }
Scb disc(const Vec3& c, double r, const Vec3& n) { return {c, r, n, 0, 0}; }

Contact verdict(const Scb& a, const Scb& b) {
    const ContactCertificate certificate = exact_overlap(a, b, strict);
    EXPECT_TRUE(certificate.contact == Contact::touching || verify(a, b, certificate))
        << certificate.margin;
    return certificate.contact;
}

// The second SCB is moved along the direction until the two have the gap, which is 0 at `contact`.
void expect_contact(const Scb& a, Scb b, const Vec3& contact, const Vec3& outward) {
    for (const double gap : {1e-11, 1e-9, 1e-6, 1e-3}) {
        b.c = contact + gap * outward;
        const ContactCertificate apart = exact_overlap(a, b, strict);
        EXPECT_EQ(apart.contact, Contact::disjoint) << gap;
        EXPECT_TRUE(verify(a, b, apart)) << gap;
        EXPECT_NEAR(apart.margin, gap, 1e-14 + 1e-6 * gap);
        b.c = contact - gap * outward;
        EXPECT_EQ(verdict(a, b), Contact::overlapping) << gap;
    }
    b.c = contact;
    EXPECT_EQ(verdict(a, b), Contact::touching);
}

struct FramedPair {
    Scb a, b;
    double gap;
};

FramedPair random_pair(Random& random, const ScbPairFamily& family) {
    const ScbPair pair = random_scb_pair(random, family);
    return {pair.a, placed(pair.b, pair.b_to_a), pair.gap};
}

TEST(ExactScbOverlap, KnowsTwoBalls) {
    const Vec3 d = Vec3(1, -2, 2) / 3;
    expect_contact(ball(Vec3::Zero(), 1), ball(Vec3::Zero(), 0.25), 1.25 * d, d);
    // Upon each other, and one within the other.
    EXPECT_EQ(verdict(ball(d, 1), ball(d, 1)), Contact::overlapping);
    EXPECT_EQ(verdict(ball(d, 1), ball(d, 1e-3)), Contact::overlapping);
}

TEST(ExactScbOverlap, KnowsCoaxialSlabs) {
    const Scb a{Vec3::Zero(), 1, Vec3::UnitZ(), 0.1, -0.2},
        b{Vec3::Zero(), 2, Vec3::UnitZ(), 0.5, -0.3};
    expect_contact(a, b, Vec3(0, 0, 0.4), Vec3::UnitZ());
    expect_contact(a, b, Vec3(0, 0, -0.7), -Vec3::UnitZ());
    // A slab that leaves its center out.
    const Scb cap{Vec3::Zero(), 1, Vec3::UnitZ(), 0.9, 0.7};
    expect_contact(a, cap, Vec3(0.1, 0, 0.1 - 0.7), Vec3::UnitZ());
}

TEST(ExactScbOverlap, KnowsADiscEdgeOnAgainstADisc) {
    const Scb flat = disc(Vec3::Zero(), 1, Vec3::UnitZ());
    // The rim of the upright disc touches the flat one within, where the planes cross at a right
    // angle.
    expect_contact(flat, disc(Vec3::Zero(), 0.5, Vec3::UnitX()), Vec3(0.2, 0.1, 0.5),
                   Vec3::UnitZ());
    // Rim against rim.
    expect_contact(flat, disc(Vec3::Zero(), 0.5, Vec3::UnitY()), Vec3(1.5, 0, 0), Vec3::UnitX());
}

TEST(ExactScbOverlap, KnowsFlatDiscsInParallelPlanes) {
    const Scb a = disc(Vec3::Zero(), 1, Vec3::UnitZ());
    EXPECT_EQ(verdict(a, disc(Vec3(0, 0, 1e-12), 1, Vec3::UnitZ())), Contact::disjoint);
    EXPECT_EQ(verdict(a, disc(Vec3(0, 2 + 1e-12, 0), 1, -Vec3::UnitZ())), Contact::disjoint);
    // In one plane they only touch: the least move parts them.
    EXPECT_EQ(verdict(a, disc(Vec3(0, 0.5, 0), 1, Vec3::UnitZ())), Contact::touching);
}

TEST(ExactScbOverlap, KnowsThinSlabsThatAreNearlyParallel) {
    for (const double angle : {1e-9, 1e-7, 1e-5, 1e-3}) {
        const Vec3 n = Vec3(angle, 0, 1) / std::sqrt(1 + angle * angle);
        for (const double half : {0.0, 1e-12, 1e-9}) {
            const Scb a{Vec3::Zero(), 1, Vec3::UnitZ(), half, -half};
            // B slopes from its edge at z = 0 (x = -0.8) upward, or crosses A's plane at its
            // center.
            const double rise = 0.8 * (angle / std::sqrt(1 + angle * angle));
            const Scb b{Vec3(0.8, 0, -rise), 1, n, half, -half};
            EXPECT_EQ(verdict(a, b), Contact::overlapping) << angle << ' ' << half;
            // The lowest point that B has above A is beyond A's rim.
            Scb above = b;
            above.c = Vec3(0.8, 0, rise + 2.1 * half + angle);
            EXPECT_EQ(verdict(a, above), Contact::disjoint) << angle << ' ' << half;
        }
    }
}

TEST(ExactScbOverlap, TakesPointsAndPoles) {
    const Scb point = ball(Vec3(0, 0, 0.3), 0), a{Vec3::Zero(), 1, Vec3::UnitZ(), 0.5, -0.2};
    EXPECT_EQ(verdict(a, point), Contact::overlapping);
    EXPECT_EQ(verdict(point, a), Contact::overlapping);
    EXPECT_EQ(verdict(a, ball(Vec3(0, 0, 0.6), 0)), Contact::disjoint);
    EXPECT_EQ(verdict(ball(Vec3(0, 0, 0.6), 0), a), Contact::disjoint);
    EXPECT_EQ(verdict(point, point), Contact::touching);
    EXPECT_EQ(verdict(point, ball(Vec3(1, 0, 0), 0)), Contact::disjoint);
    // All that is left of the ball is the pole: no point is both in the ball and on the plane but
    // by rounding, so nothing is proven.
    const Scb pole{Vec3(0, 0, 1.2), 1, Vec3::UnitZ(), -1, -1};
    EXPECT_EQ(verdict(a, pole), Contact::touching);
    EXPECT_EQ(verdict(a, {Vec3(0, 0, 1.6), 1, Vec3::UnitZ(), -1, -1}), Contact::disjoint);
}

TEST(ExactScbOverlap, ProvesNearlyEveryPair) {
    long undecided = 0, pairs = 0;
    for (const ScbPairFamily& family : scb_pair_families) {
        Random random(7);
        for (int i = 0; i < many_scbs; ++i, ++pairs) {
            const FramedPair p = random_pair(random, family);
            const ContactCertificate certificate = exact_overlap(p.a, p.b, strict);
            if (certificate.contact == Contact::touching) {
                ++undecided;
                continue;
            }
            ASSERT_TRUE(verify(p.a, p.b, certificate)) << family.name << " pair " << i;
            if (!family.near_contact) continue;
            if (p.gap > 0) {
                ASSERT_EQ(certificate.contact, Contact::disjoint) << family.name << " pair " << i;
                ASSERT_LE(certificate.margin, p.gap + 1e-14) << family.name << " pair " << i;
            }
        }
    }
    const double share = static_cast<double>(undecided) / static_cast<double>(pairs);
    std::printf("undecided: %.2g of %ld pairs\n", share, pairs);
    EXPECT_LT(share, 1e-4);
}

// No certificates here: points and directions drawn at random.
TEST(ExactScbOverlap, AgreesWithSamples) {
    Random random(8);
    long common = 0, separated = 0;
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < std::max(many_scbs / 500, 40); ++i) {
            const FramedPair p = random_pair(random, family);
            const Contact found = exact_overlap(p.a, p.b, strict).contact;
            for (int k = 0; k < 200; ++k) {
                const Scb& from = p.a.r < p.b.r ? p.a : p.b;
                const Vec3 x = from.c + from.r * random_point(random);
                // Onto the slab, where it is thin.
                const double h = dot(from.n, Vec3(x - from.c));
                const Vec3 y = x + (std::clamp(h, from.f, from.e) - h) * from.n;
                if (contains(p.a, y) && contains(p.b, y)) {
                    ++common;
                    ASSERT_NE(found, Contact::disjoint) << family.name << " pair " << i;
                }
                const Vec3 d = random_unit_vector(random);
                if (dot(d, Vec3(p.b.c - p.a.c)) - support(p.a, d) - support(p.b, -d) > 1e-12) {
                    ++separated;
                    ASSERT_NE(found, Contact::overlapping) << family.name << " pair " << i;
                }
            }
        }
    EXPECT_GT(common, 0);
    EXPECT_GT(separated, 0);
}

// Exchange, flip, a rigid motion and a scale: never the contrary, and hardly ever undecided
// instead.
TEST(ExactScbOverlap, IsInvariant) {
    Random random(9);
    long changed = 0, pairs = 0;
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < many_scbs / 20; ++i, ++pairs) {
            const FramedPair p = random_pair(random, family);
            const Pose pose = random_pose(random);
            const double factor = log_uniform(random, 1e-6, 1e6);
            const Contact found = exact_overlap(p.a, p.b, strict).contact;
            for (const Contact other :
                 {exact_overlap(p.b, p.a, strict).contact,
                  exact_overlap(flipped(p.a), p.b, strict).contact,
                  exact_overlap(p.a, flipped(p.b), strict).contact,
                  exact_overlap(placed(p.a, pose), placed(p.b, pose), strict).contact,
                  exact_overlap(scaled(p.a, factor), scaled(p.b, factor), strict).contact}) {
                if (other == found) continue;
                ++changed;
                ASSERT_TRUE(other == Contact::touching || found == Contact::touching)
                    << family.name << " pair " << i;
            }
        }
    EXPECT_LE(changed, pairs / 5000);
}

TEST(ScbContactProof, DepthIsHowFarBMustBeMoved) {
    Random random(10);
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < many_scbs / 100; ++i) {
            const FramedPair p = random_pair(random, family);
            // A wider tolerance asks for a deeper point.
            const ContactCertificate certificate = exact_overlap(p.a, p.b, 1e-4);
            if (certificate.contact != Contact::overlapping) continue;
            const double depth = proven_depth(p.a, p.b, certificate.point);
            ASSERT_GE(depth, certificate.margin * (1 - 1e-9));
            for (const Vec3& d : {p.a.n, p.b.n, random_unit_vector(random),
                                  random_unit_vector(random), random_unit_vector(random)})
                for (const double side : {-1.0, 1.0}) {
                    Scb away = p.b;
                    away.c += 0.999 * side * depth * d;
                    ASSERT_NE(exact_overlap(p.a, away, strict).contact, Contact::disjoint)
                        << family.name << " pair " << i;
                }
        }
}

// Weak duality: for every m, d.(x - c) <= r |d - m n| + max(m e, m f), since it holds for the parts
// d - m n and m n of d.
TEST(ScbContactProof, GapHoldsForEveryPoint) {
    Random random(11);
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < many_scbs / 500; ++i) {
            const FramedPair p = random_pair(random, family);
            const Vec3 d = random_unit_vector(random);
            const auto bound = [](const Scb& s, const Vec3& direction, double m) {
                return s.r * (direction - m * s.n).norm() + std::max(m * s.e, m * s.f);
            };
            const auto least_bound = [&](const Scb& s, const Vec3& direction) {
                double lower = -1e3, upper = 1e3;
                for (int k = 0; k < 120; ++k) {
                    const double left = lower + (upper - lower) / 3,
                                 right = upper - (upper - lower) / 3;
                    (bound(s, direction, left) < bound(s, direction, right) ? upper : lower) =
                        bound(s, direction, left) < bound(s, direction, right) ? right : left;
                }
                return bound(s, direction, lower);
            };
            const double gap =
                dot(d, Vec3(p.b.c - p.a.c)) - least_bound(p.a, d) - least_bound(p.b, -d);
            ASSERT_NEAR(proven_gap(p.a, p.b, d), gap, 1e-9) << family.name << " pair " << i;
            ASSERT_NEAR(proven_gap(p.a, p.b, d),
                        dot(d, Vec3(p.b.c - p.a.c)) - support(p.a, d) - support(p.b, -d), 1e-14);
        }
}

TEST(ScbContactProof, IsRefusedWhereItDoesNotHold) {
    const Scb a = ball(Vec3::Zero(), 1), apart = ball(Vec3(0, 0, 2.5), 1),
              close = ball(Vec3(0, 0, 1.5), 1);
    const Vec3 up = Vec3::UnitZ();
    EXPECT_TRUE(verify(a, apart, {Contact::disjoint, up, Vec3::Zero(), 0.5}));
    EXPECT_FALSE(verify(a, apart, {Contact::disjoint, -up, Vec3::Zero(), 0.5}));
    EXPECT_FALSE(verify(a, apart, {Contact::disjoint, up, Vec3::Zero(), 0.51}));
    EXPECT_FALSE(verify(a, close, {Contact::disjoint, up, Vec3::Zero(), 0.5}));
    EXPECT_TRUE(verify(a, close, {Contact::overlapping, up, 0.75 * up, 0.5}));
    EXPECT_FALSE(verify(a, close, {Contact::overlapping, up, 0.75 * up, 0.51}));
    EXPECT_FALSE(verify(a, close, {Contact::overlapping, up, 1.1 * up, 0.1}));
    EXPECT_FALSE(verify(a, close, {Contact::touching, up, 0.75 * up, 0.5}));
    // A direction of no length.
    EXPECT_FALSE(verify(a, apart, {Contact::disjoint, Vec3::Zero(), Vec3::Zero(), 0.5}));
}

// Squares of these lengths underflow to 0, so they determine no distance.
TEST(ScbContactProof, IsRefusedOfLengthsThatAreTooSmall) {
    constexpr double tiny = 1e-170;
    const Scb a = ball(Vec3::Zero(), tiny), apart = ball(Vec3(0, 0, 5 * tiny), tiny);
    const Ball round{Vec3::Zero(), tiny}, round_apart{Vec3(0, 0, 5 * tiny), tiny};
    const Obb box{Vec3::Zero(), Mat3::Identity(), Vec3::Constant(tiny)},
        box_apart{Vec3(0, 0, 5 * tiny), Mat3::Identity(), Vec3::Constant(tiny)};
    const ContactCertificate claim{Contact::overlapping, Vec3::Zero(), Vec3::Zero(), tiny};
    EXPECT_FALSE(verify(a, apart, claim));
    EXPECT_FALSE(verify(round, round_apart, claim));
    EXPECT_FALSE(verify(box, box_apart, claim));
    // Next to lengths that are not, it is.
    const Scb far = ball(Vec3(0, 0, 2), tiny);
    EXPECT_TRUE(verify(a, far, exact_overlap(a, far)));
    // Nor of a direction that is next to nothing.
    const Scb unit = ball(Vec3::Zero(), 1), beyond = ball(Vec3(0, 0, 2.5), 1);
    EXPECT_FALSE(verify(unit, beyond, {Contact::disjoint, Vec3(0, 0, 3e-162), Vec3::Zero(), 0.5}));
}

TEST(RandomScbPairs, AreWellFormedAndCloseToContact) {
    Random random(12);
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < many_scbs / 20; ++i) {
            const ScbPair pair = random_scb_pair(random, family);
            ASSERT_TRUE(is_well_formed(pair.a)) << family.name << " pair " << i;
            ASSERT_TRUE(is_well_formed(pair.b)) << family.name << " pair " << i;
            ASSERT_LT(rigidity_defect(pair.b_to_a), 1e-14);
            for (const Scb& s : {pair.a, pair.b})
                ASSERT_TRUE(!family.centered || (s.f <= 0 && 0 <= s.e));
            const double ratio = pair.a.r / pair.b.r;
            ASSERT_TRUE(0.99e-3 < ratio && ratio < 1.01e3);
        }
}

// FNV-1a over the bits: the same pairs with every compiler, standard library and CPU.
TEST(RandomScbPairs, AreTheSameEverywhere) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](double value) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x100000001b3u;
    };
    Random random(13);
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < 1000; ++i) {
            const ScbPair pair = random_scb_pair(random, family);
            for (const Scb& s : {pair.a, pair.b})
                for (const double value :
                     {s.c[0], s.c[1], s.c[2], s.r, s.n[0], s.n[1], s.n[2], s.e, s.f})
                    add(value);
            for (int k = 0; k < 9; ++k) add(pair.b_to_a.rotation(k / 3, k % 3));
            for (int k = 0; k < 3; ++k) add(pair.b_to_a.translation[k]);
        }
    EXPECT_EQ(hash, 0xdb2f97df6109c0efu);
}

}  // namespace
}  // namespace scb
