#include "core/explain/exact_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/explain/contact_certificate.h"
#include "core/volumes/shape.h"
#include "scb/capsule.h"
#include "scb/overlap.h"
#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/core/overlap/scb2_pairs.h"
#include "tests/unless_sanitized.h"

namespace scb {
namespace {

constexpr int many_pairs = unless_sanitized(50000, 2000);

Obb random_box(Random& random) {
    const Pose pose = random_pose(random);
    Obb box{pose.translation, pose.rotation, Vec3::Zero()};
    for (int i = 0; i < 3; ++i)
        box.half[i] = random.below(8) == 0 ? 0 : log_uniform(random, 1e-3, 1);
    return box;
}

Ball random_ball(Random& random) {
    return {random_pose(random).translation,
            random.below(8) == 0 ? 0 : log_uniform(random, 1e-3, 1)};
}

Scb at_origin(Scb s) {
    s.c = Vec3::Zero();
    return s;
}

/// B moved so that the gap along the best direction found is near nothing, or by `gap`.
template <class V>
V moved_to_contact(const V& a, V b, double gap) {
    // A step along the separating direction changes the gap by the step at most, so a few come
    // close to where the two touch.
    for (int i = 0; i < 30; ++i) {
        const ContactCertificate certificate = exact_overlap(a, b);
        if (certificate.contact == Contact::disjoint)
            b.center -= certificate.margin * certificate.direction;
        if (certificate.contact != Contact::disjoint) break;
    }
    const Vec3 direction = (b.center - a.center).normalized();
    b.center += gap * direction;
    return b;
}

template <class V>
void expect_proven(const V& a, const V& b) {
    const ContactCertificate certificate = exact_overlap(a, b);
    const Stage stage = overlap(a, b, Pose{});
    if (certificate.contact == Contact::disjoint) {
        EXPECT_TRUE(verify(a, b, certificate));
        EXPECT_NE(stage, Stage::overlapping) << "the test of these volumes is exact";
    } else if (certificate.contact == Contact::overlapping) {
        EXPECT_TRUE(verify(a, b, certificate));
        EXPECT_EQ(stage, Stage::overlapping) << "the test of these volumes is exact";
    }
}

/// Random pairs, half of them close to contact; the centers of the others are up to `farthest` as
/// far apart as they are drawn.
template <class V>
void expect_all_proven(Random random, V (*random_volume)(Random&), double farthest) {
    int counts[3] = {};
    for (int i = 0; i < many_pairs; ++i) {
        const V a = random_volume(random);
        V b = random_volume(random);
        b.center = a.center + farthest * random.uniform() * (b.center - a.center);
        if (i % 2 == 0) {
            const double gap = log_uniform(random, 1e-8, 1e-3);
            b = moved_to_contact(a, b, i % 4 == 0 ? gap : -gap);
        }
        expect_proven(a, b);
        ++counts[static_cast<int>(exact_overlap(a, b).contact)];
    }
    for (const Contact contact : {Contact::disjoint, Contact::overlapping})
        EXPECT_GT(counts[static_cast<int>(contact)], many_pairs / 10);
    EXPECT_LT(counts[static_cast<int>(Contact::touching)], many_pairs / 20);
}

TEST(ExactOverlap, OfBoxesAgreesWithTheFifteenAxesAndProvesIt) {
    expect_all_proven(Random(1), random_box, 2);
}

TEST(ExactOverlap, OfBallsAgreesWithTheirTestAndProvesIt) {
    expect_all_proven(Random(2), random_ball, 1);
}

/// The number of pairs that are apart along their centers; each must be disjoint.
template <class V>
int apart_pairs(Random random, V (*random_volume)(Random&)) {
    int apart = 0;
    for (int i = 0; i < many_pairs; ++i) {
        const V a = random_volume(random);
        V b = random_volume(random);
        b.center = a.center + 2 * random.uniform() * (b.center - a.center);
        if (i % 2 == 0) b = moved_to_contact(a, b, log_uniform(random, 1e-12, 1e-6));
        const Placement placed = placement(Pose{}, 4, 4);
        if (!apart_along_centers(a, b, placed)) continue;
        EXPECT_EQ(exact_verdict(a, b, placed).contact, Contact::disjoint);
        ++apart;
    }
    return apart;
}

template <class V>
bool apart(const V& a, const V& b) {
    const Placement placed = placement(Pose{}, 400, 400);
    const bool found = apart_along_centers(shape_of(a), shape_of(b), placed);
    if (found) {
        EXPECT_EQ(exact_verdict(shape_of(a), shape_of(b), placed).contact, Contact::disjoint);
    }
    return found;
}

// Of sizes above and below 1.
TEST(ExactOverlap, IsDisjointWhereCentersShowItForAnyVolume) {
    for (const double size : {0.01, 1.0, 100.0}) {
        const auto capsule = [&](double x) {
            return Capsule{size * Vec3(x, 0, 0), size * Vec3(0, 0, 1), size * 2};
        };
        EXPECT_FALSE(apart(capsule(0), capsule(3)));
        EXPECT_TRUE(apart(capsule(0), capsule(4.1)));
        const auto scb = [&](double x) {
            return Scb{size * Vec3(x, 0, 0), size, Vec3::UnitX(), size / 2, -size / 2};
        };
        EXPECT_FALSE(apart(scb(0), scb(0.9)));
        EXPECT_TRUE(apart(scb(0), scb(1.1)));
        const auto scb2 = [&](double x) {
            return Scb2{
                size * Vec3(x, 0, 0),
                size,
                {Slab{Vec3::UnitX(), size / 2, -size / 2}, Slab{Vec3::UnitY(), size, -size}}};
        };
        EXPECT_FALSE(apart(scb2(0), scb2(0.9)));
        EXPECT_TRUE(apart(scb2(0), scb2(1.1)));
    }
}

TEST(ExactOverlap, IsDisjointWhereCentersShowIt) {
    EXPECT_GT(apart_pairs(Random(3), random_ball), many_pairs / 3);
    EXPECT_GT(apart_pairs(Random(4), random_box), many_pairs / 10);
}

TEST(ExactOverlap, KnowsBoxesThatOnlyTouch) {
    const Obb unit{Vec3::Zero(), Mat3::Identity(), Vec3::Constant(1)};
    for (const Vec3& at : {Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(2, 2, 2), Vec3(0, -2, 0.3)}) {
        EXPECT_EQ(exact_overlap(unit, Obb{at, unit.axes, unit.half}).contact, Contact::touching);
        EXPECT_EQ(exact_overlap(unit, Obb{at * (1 + 1e-7), unit.axes, unit.half}).contact,
                  Contact::disjoint);
        EXPECT_EQ(exact_overlap(unit, Obb{at * (1 - 1e-7), unit.axes, unit.half}).contact,
                  Contact::overlapping);
    }
    // Two flat boxes that cross, though no ball fits into either.
    const Obb flat{Vec3::Zero(), Mat3::Identity(), Vec3(1, 1, 0)},
        upright{Vec3::Zero(), Mat3::Identity(), Vec3(0, 0.5, 0.5)};
    const ContactCertificate certificate = exact_overlap(flat, upright);
    EXPECT_EQ(certificate.contact, Contact::overlapping);
    EXPECT_TRUE(verify(flat, upright, certificate));
}

TEST(ExactOverlap, KnowsTwoSlabsThatOnlyTouch) {
    // As boxes in the middle of long needles.
    const auto needle = [](const Vec3& at) {
        return Scb2{at, 100, {Slab{Vec3::UnitX(), 1, -1}, Slab{Vec3::UnitY(), 1, -1}}};
    };
    for (const Vec3& at : {Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(0, -2, 0.3), Vec3(-2, 0.5, 7)}) {
        EXPECT_EQ(exact_overlap(needle(Vec3::Zero()), needle(at)).contact, Contact::touching);
        EXPECT_EQ(exact_overlap(needle(Vec3::Zero()), needle(at * (1 + 1e-6))).contact,
                  Contact::disjoint);
        EXPECT_EQ(exact_overlap(needle(Vec3::Zero()), needle(at * (1 - 1e-6))).contact,
                  Contact::overlapping);
    }
    // End to end, by their spheres.
    for (const double share : {1 - 1e-8, 1.0, 1 + 1e-8}) {
        const Contact contact =
            exact_overlap(needle(Vec3::Zero()), needle(Vec3(0, 0, 200 * share))).contact;
        EXPECT_EQ(contact, share < 1   ? Contact::overlapping
                           : share > 1 ? Contact::disjoint
                                       : Contact::touching);
    }
    // Two flat ones that cross, though no ball fits into either.
    const Scb2 flat{Vec3::Zero(), 2, {Slab{Vec3::UnitZ(), 0, 0}, Slab{Vec3::UnitX(), 1, -1}}},
        upright{Vec3::Zero(), 1, {Slab{Vec3::UnitX(), 0, 0}, Slab{Vec3::UnitY(), 0.5, -0.5}}};
    const ContactCertificate certificate = exact_overlap(flat, upright);
    EXPECT_EQ(certificate.contact, Contact::overlapping);
    EXPECT_TRUE(verify(flat, upright, certificate));
}

// Where the second slab cuts nothing, there are two oracles.
TEST(ExactOverlap, OfTwoSlabsAgreesWithThatOfOne) {
    Random random(4);
    int decided = 0;
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < many_pairs / 100; ++i) {
            const ScbPair pair = random_scb_pair(random, family);
            const Scb b = placed(pair.b, pair.b_to_a);
            if (!family.centered) continue;
            const auto with_second = [&](const Scb& s) {
                const Vec3 axis = std::abs(s.n[0]) < 0.5 ? Vec3::UnitX() : Vec3::UnitY();
                Vec3 n = cross(s.n, axis);
                n /= std::sqrt(squared_norm(n));
                return Scb2{s.c, s.r, {Slab{s.n, s.e, s.f}, Slab{n, s.r, -s.r}}};
            };
            const Contact one = exact_overlap(pair.a, b).contact,
                          two = exact_overlap(with_second(pair.a), with_second(b)).contact;
            // Depths are lower bounds, so either may call touching what is a little deep.
            EXPECT_TRUE(one == two || one == Contact::touching || two == Contact::touching);
            decided += one == two && one != Contact::touching;
        }
    EXPECT_GT(decided, many_pairs / 100 * 5);
}

/// How far B has to go along the best direction of a random search to be rid of A: no depth is
/// more.
template <class V>
double way_out(Random& random, const V& a, const V& b, const Vec3& to_b) {
    const auto along = [&](const Vec3& d) { return support(a, d) + support(b, -d) - dot(d, to_b); };
    Vec3 best = random_unit_vector(random);
    double least = along(best);
    const auto take = [&](const Vec3& d) {
        if (along(d) >= least) return;
        least = along(d);
        best = d;
    };
    for (int i = 0; i < 200; ++i) take(random_unit_vector(random));
    for (double step = 0.3; step > 1e-8; step /= 1.5)
        for (int i = 0; i < 12; ++i)
            take(Vec3(best + step * random_unit_vector(random)).normalized());
    return least;
}

TEST(SharpenedProof, IsNoDeeperThanAWayOut) {
    Random random(5);
    int scbs = 0, boxes = 0;
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < many_pairs / 500; ++i) {
            const ScbPair pair = random_scb_pair(random, family);
            const Scb b = placed(pair.b, pair.b_to_a);
            const ContactCertificate certificate = sharpened(pair.a, b, exact_overlap(pair.a, b));
            if (certificate.contact != Contact::overlapping) continue;
            EXPECT_LE(certificate.margin, way_out(random, pair.a, b, b.c - pair.a.c) + 1e-12);
            EXPECT_TRUE(check_certificate(pair.a, b, certificate)) << family.name << " " << i;
            ++scbs;
        }
    int two_slabs = 0;
    for (const Scb2PairFamily& family : scb2_pair_families)
        for (int i = 0; i < many_pairs / 500; ++i) {
            const VolumePair<Scb2> pair = random_scb2_pair(random, family);
            const Scb2 b = placed(pair.b, pair.b_to_a);
            const ContactCertificate certificate = sharpened(pair.a, b, exact_overlap(pair.a, b));
            if (certificate.contact != Contact::overlapping) continue;
            EXPECT_LE(certificate.margin, way_out(random, pair.a, b, b.c - pair.a.c) + 1e-12);
            EXPECT_TRUE(check_certificate(pair.a, b, certificate)) << family.name << " " << i;
            ++two_slabs;
        }
    EXPECT_GT(two_slabs, many_pairs / 1000);
    for (int i = 0; i < many_pairs / 100; ++i) {
        const Obb a = random_box(random);
        Obb b = random_box(random);
        b.center = a.center + 0.5 * random.uniform() * (b.center - a.center);
        const ContactCertificate certificate = sharpened(a, b, exact_overlap(a, b));
        if (certificate.contact != Contact::overlapping) continue;
        EXPECT_LE(certificate.margin, way_out(random, a, b, b.center - a.center) + 1e-12);
        EXPECT_TRUE(check_certificate(a, b, certificate)) << i;
        ++boxes;
    }
    EXPECT_GT(scbs, many_pairs / 1000);
    EXPECT_GT(boxes, many_pairs / 1000);
}

// Whole balls, with known gap and depth.
template <class V>
void expect_borne_out_up_to(double margin, const V& a, const V& apart, const V& close) {
    const Vec3 up = Vec3::UnitZ();
    for (const double factor : {0.5, 1.0}) {
        const double claimed = factor * margin;
        EXPECT_TRUE(check_certificate(a, apart, {Contact::disjoint, up, Vec3::Zero(), claimed}));
        EXPECT_TRUE(
            check_certificate(a, close, {Contact::overlapping, Vec3::Zero(), 0.75 * up, claimed}));
    }
    const double more = margin + 1e-9;
    EXPECT_FALSE(check_certificate(a, apart, {Contact::disjoint, up, Vec3::Zero(), more}));
    EXPECT_FALSE(check_certificate(a, apart, {Contact::disjoint, -up, Vec3::Zero(), margin}));
    EXPECT_FALSE(
        check_certificate(a, close, {Contact::overlapping, Vec3::Zero(), 0.75 * up, more}));
    // Not a point of both.
    EXPECT_FALSE(check_certificate(a, close, {Contact::overlapping, up, 1.1 * up, margin}));
    EXPECT_FALSE(check_certificate(a, close, {Contact::overlapping, up, 0.4 * up, margin}));
    EXPECT_FALSE(check_certificate(a, a, ContactCertificate{}));
}

TEST(CertificateCheck, RefusesMarginsThatFarthestPointsDoNotLeave) {
    const auto ball = [](double z) { return Ball{Vec3(0, 0, z), 1}; };
    expect_borne_out_up_to(0.5, ball(0), ball(2.5), ball(1.5));
    const auto whole = [](double z) { return Scb{Vec3(0, 0, z), 1, Vec3::UnitX(), 1, -1}; };
    expect_borne_out_up_to(0.5, whole(0), whole(2.5), whole(1.5));
    const auto cut = [](double z) { return Scb{Vec3(0, 0, z), 3, Vec3::UnitZ(), 1, -1}; };
    expect_borne_out_up_to(0.5, cut(0), cut(2.5), cut(1.5));
    const auto twice = [](double z) {
        return Scb2{Vec3(0, 0, z), 3, {Slab{Vec3::UnitX(), 2, -1}, Slab{Vec3::UnitZ(), 1, -1}}};
    };
    expect_borne_out_up_to(0.5, twice(0), twice(2.5), twice(1.5));
    const auto cube = [](double z) {
        return Obb{Vec3(0, 0, z), Mat3::Identity(), Vec3::Constant(1)};
    };
    expect_borne_out_up_to(0.5, cube(0), cube(2.5), cube(1.5));
}

TEST(SharpenedProof, IsTheDistanceOrTheDepthOfBalls) {
    const Ball a{Vec3(1, 2, 3), 1}, apart{Vec3(1, 2, 6), 1.5}, close{Vec3(1, 2, 5), 1.5};
    const ContactCertificate gap =
        sharpened(a, apart, {Contact::disjoint, Vec3(0.3, 0, 1).normalized(), Vec3::Zero(), 0.01});
    EXPECT_NEAR(gap.margin, 0.5, 1e-9);
    EXPECT_TRUE(verify(a, apart, gap));
    const ContactCertificate depth = sharpened(a, close, exact_overlap(a, close));
    EXPECT_NEAR(depth.margin, 0.5, 1e-9);
    EXPECT_TRUE(verify(a, close, depth));
}

TEST(SharpenedProof, IsNeverWorseAndStillProven) {
    Random random(3);
    int distances = 0, close = 0;
    for (const ScbPairFamily& family : scb_pair_families)
        for (int i = 0; i < 30; ++i) {
            const ScbPair pair = random_scb_pair(random, family);
            const Scb b = placed(pair.b, pair.b_to_a);
            const ContactCertificate certificate = exact_overlap(pair.a, b),
                                     better = sharpened(pair.a, b, certificate);
            EXPECT_EQ(better.contact, certificate.contact);
            if (certificate.contact == Contact::touching) continue;
            EXPECT_GE(better.margin, certificate.margin);
            EXPECT_TRUE(verify(pair.a, b, better)) << family.name << " " << i;
            EXPECT_TRUE(check_certificate(pair.a, b, better)) << family.name << " " << i;
            if (certificate.contact == Contact::overlapping) {
                // Still a point of both.
                const Vec3 in_b = better.point - (b.c - pair.a.c);
                EXPECT_TRUE(contains(enlarged(at_origin(pair.a), 1e-12), better.point));
                EXPECT_TRUE(contains(enlarged(at_origin(b), 1e-12), in_b));
            }
            if (family.near_contact && pair.gap > 0 && certificate.contact == Contact::disjoint) {
                EXPECT_LE(better.margin, pair.gap * (1 + 1e-9) + 1e-13);
                ++distances;
                close += better.margin >= 0.98 * pair.gap - 1e-13;
            }
        }
    // Not where the two are thin, nearly parallel and nearly touch.
    EXPECT_GE(close, distances * 9 / 10);
    EXPECT_GT(distances, 50);
}

}  // namespace
}  // namespace scb
