#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iomanip>
#include <sstream>
#include <utility>

#include "core/explain/exact_overlap.h"
#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/core/overlap/support_search.h"

// exact_overlap against a search that shares nothing with it, on a million pairs.

namespace scb {
namespace {

#ifdef SCB_SANITIZED
constexpr int drawn_per_family = 400, moved_per_gap = 40, drawn_in_lattice = 2000;
#else
constexpr int drawn_per_family = 80'000, moved_per_gap = 7'800, drawn_in_lattice = 400'000;
#endif

constexpr double gaps[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

// Shares of the larger radius. What the search must show before "touching" is called wrong:
// exact_overlap proves a gap or a depth of contact_tolerance by a plane or a point that is near the
// best one only, and asks for a multiple of the depth.
constexpr double clearly_apart = 2 * contact_tolerance, clearly_deep = 10 * contact_tolerance;
// What it can show.
constexpr double least_gap = 1e-13, least_depth = 1e-10;

struct Agreement {
    long pairs = 0, apart = 0, meeting = 0, open = 0;
    // Verdicts of "touching", although the search shows a clear gap or depth; those with a gap.
    long touching = 0, touching_apart = 0;
    long unproven = 0, contrary = 0;
    std::string first;  // of the last two

    Agreement& operator+=(const Agreement& other) {
        pairs += other.pairs;
        apart += other.apart;
        meeting += other.meeting;
        open += other.open;
        touching += other.touching;
        touching_apart += other.touching_apart;
        unproven += other.unproven;
        contrary += other.contrary;
        if (first.empty()) first = other.first;
        return *this;
    }

    void print(const char* name) const {
        std::printf("%-34s %9ld %9ld %9ld %8ld %8ld\n", name, pairs, apart, meeting, open,
                    touching);
    }
};

std::string to_text(const Scb& a, const Scb& b) {
    std::ostringstream out;
    out << std::setprecision(17);
    for (const Scb& s : {a, b})
        out << "c " << s.c.transpose() << " r " << s.r << " n " << s.n.transpose() << " e " << s.e
            << " f " << s.f << '\n';
    return out.str();
}

Agreement compare(const Scb& a, const Scb& b) {
    const double larger = std::max(a.r, b.r);
    const ContactCertificate certificate = exact_overlap(a, b);
    const SupportBounds shown = search_supports(a, b, clearly_apart * larger,
                                                {clearly_deep * larger, least_depth * larger});
    Agreement result;
    result.pairs = 1;
    result.unproven = certificate.contact != Contact::touching && !verify(a, b, certificate);
    if (shown.lower > least_gap * larger) {
        result.apart = 1;
        result.contrary = certificate.contact == Contact::overlapping;
        result.touching = result.touching_apart =
            certificate.contact == Contact::touching && shown.lower > clearly_apart * larger;
    } else if (shown.depth > 0) {
        result.meeting = 1;
        result.contrary = certificate.contact == Contact::disjoint;
        result.touching =
            certificate.contact == Contact::touching && shown.depth >= clearly_deep * larger;
    } else {
        result.open = 1;
    }
    // A separating plane and a common point exclude each other, in every case.
    result.contrary |=
        certificate.contact == Contact::disjoint && certificate.margin > shown.upper + 1e-13;
    if (result.unproven + result.contrary > 0) result.first = to_text(a, b);
    return result;
}

Agreement compare(const ScbPair& pair) { return compare(pair.a, placed(pair.b, pair.b_to_a)); }

// A slab cut ball with numbers from a short list, so that two of them often touch exactly: planes
// through each other's centers and tangent to each other's balls, rims that touch planes, slabs
// that are a disc or a point. The normal is one of the axes. Many sides form right triangles of 3,
// 4 and 5.
Scb lattice_scb(Random& random) {
    constexpr std::array radii = {0.5, 1.0, 2.0};
    constexpr std::array heights = {-1.0, -0.8, -0.6, 0.0, 0.6, 0.8, 1.0};
    const auto one_of = [&](const auto& list) {
        return list[random.below(static_cast<std::uint32_t>(list.size()))];
    };
    Scb s;
    for (int i = 0; i < 3; ++i) s.c[i] = 0.25 * random.below(9) - 1;
    s.r = one_of(radii);
    s.n = (random.below(2) == 0 ? 1 : -1) * Vec3::Unit(random.below(3));
    const double one = s.r * one_of(heights),
                 other = random.below(2) == 0 ? one : s.r * one_of(heights);
    s.e = std::max(one, other);
    s.f = std::min(one, other);
    return s;
}

// Where a slab only just touches the other volume, the two have one point in common with it, far
// from the other's rim perhaps.
TEST(ExactScbOverlap, AgreesWithTheSearchOnExactTangencies) {
    Random random(15);
    Agreement sum;
    std::string first;
    for (int i = 0; i < drawn_in_lattice; ++i) {
        const Scb a = lattice_scb(random);
        Scb b = lattice_scb(random);
        // Half of them miss by less than what is told apart, or are in each other by as little.
        if (i % 2 == 1) b.c[random.below(3)] += contact_tolerance * a.r * random.uniform(-1, 1);
        const Agreement one = compare(a, b);
        if (one.touching_apart > 0 && first.empty()) first = to_text(a, b);
        sum += one;
    }
    sum.print("lattice");
    EXPECT_EQ(sum.unproven + sum.contrary, 0) << sum.first;
    // A single point of a sphere touches, however deep it is in the other.
    EXPECT_EQ(sum.touching_apart, 0) << first;
    EXPECT_GT(sum.apart, drawn_in_lattice / 10);
    EXPECT_GT(sum.meeting, drawn_in_lattice / 10);
}

TEST(ExactScbOverlap, KnowsDiscsWhosePlanesTouchTheOther) {
    const Scb a{Vec3(1, 0.25, 0), 2, Vec3::UnitY(), -1.2, -1.2},
        b{Vec3(0.5, 0.25, 0), 2, Vec3::UnitZ(), 1.6, 1.6};
    const SupportBounds shown = search_supports(a, b, 1, {1e-10});
    EXPECT_NEAR(shown.lower, 0.0316745, 1e-7);
    EXPECT_NEAR(shown.upper, 0.0316745, 1e-7);
    for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
        const ContactCertificate certificate = exact_overlap(first, second);
        EXPECT_EQ(certificate.contact, Contact::disjoint);
        EXPECT_TRUE(verify(first, second, certificate));
        EXPECT_GT(certificate.margin, 0.01);
        EXPECT_NEAR(sharpened(first, second, certificate).margin, 0.0316745, 1e-6);
    }
}

TEST(ExactScbOverlap, AgreesWithASearchOnFarthestPoints) {
    std::printf("%-34s %9s %9s %9s %8s %8s\n", "family", "pairs", "apart", "meeting", "open",
                "touching");
    Agreement all, close;
    for (const ScbPairFamily& family : scb_pair_families) {
        Agreement sum;
        Random random(14);
        for (int i = 0; i < drawn_per_family; ++i) sum += compare(random_scb_pair(random, family));
        if (family.near_contact)
            for (const double gap : gaps)
                for (int i = 0; i < moved_per_gap; ++i) {
                    const ScbPair pair = scb_pair_at_gap(random, family, i % 2 == 0 ? gap : -gap);
                    const Agreement one = compare(pair);
                    // How far these were moved apart is a third opinion.
                    ASSERT_TRUE(pair.gap < 0 || one.apart == 1) << to_text(pair.a, pair.b);
                    close += one;
                }
        sum.print(family.name.data());
        EXPECT_EQ(sum.unproven + sum.contrary, 0) << family.name << ", the first:\n" << sum.first;
        all += sum;
    }
    close.print("gaps of 1e-3 to 1e-8");
    EXPECT_EQ(close.unproven + close.contrary, 0) << close.first;
    all += close;
    all.print("all");
#ifndef SCB_SANITIZED
    EXPECT_GE(all.pairs, 1'000'000);
#endif
    EXPECT_GT(all.apart, all.pairs / 3);
    EXPECT_GT(all.meeting, all.pairs / 5);
    // Most of these are within the tolerance, or so thin that no ball of the least depth is in the
    // set of differences.
    EXPECT_LT(all.open, all.pairs / 50 + 3);
    // Slabs of hardly any thickness, nearly parallel, at their rims: see exact_overlap.
    EXPECT_LT(all.touching, all.pairs / 2500 + 3);
}

// The search itself, where the answer is known.
TEST(SupportSearch, KnowsTwoBalls) {
    const Scb a{Vec3::Zero(), 1, Vec3::UnitZ(), 1, -1};
    for (const double gap : {1e-9, 1e-5, 1e-2, 0.5}) {
        Scb b{(1.25 + gap) * Vec3(1, -2, 2) / 3, 0.25, Vec3::UnitX(), 0.25, -0.25};
        const SupportBounds apart = search_supports(a, b, 10, {1e-10});
        EXPECT_NEAR(apart.lower, gap, 1e-11);
        EXPECT_NEAR(apart.upper, gap, 1e-11);
        EXPECT_EQ(apart.depth, 0);
        b.c = (1.25 - gap) * Vec3(1, -2, 2) / 3;
        const SupportBounds deep = search_supports(a, b, 10, {1.01 * gap, 0.2 * gap});
        EXPECT_LT(deep.lower, 0);
        EXPECT_EQ(deep.depth, 0.2 * gap);
    }
}

TEST(SupportSearch, KnowsTwoDiscs) {
    const Scb flat{Vec3::Zero(), 1, Vec3::UnitZ(), 0, 0};
    // Above each other, and one beside the other in its plane.
    EXPECT_NEAR(
        search_supports(flat, {Vec3(0.3, 0, 1e-6), 1, Vec3::UnitZ(), 0, 0}, 1, {1e-10}).lower, 1e-6,
        1e-15);
    EXPECT_NEAR(search_supports(flat, {Vec3(3, 0, 0), 1, Vec3::UnitZ(), 0, 0}, 10, {1e-10}).lower,
                1, 1e-12);
    // Crossing at a right angle.
    const Scb upright{Vec3(0.2, 0.1, 0.4), 0.5, Vec3::UnitX(), 0, 0};
    EXPECT_EQ(search_supports(flat, upright, 1, {0.01}).depth, 0.01);
}

}  // namespace
}  // namespace scb
