#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "core/exact_overlap.h"
#include "tests/core/random_scb_pairs.h"
#include "tests/core/support_search.h"

// exact_overlap against a search that shares nothing with it, on a million pairs.

namespace scb {
namespace {

#ifdef SCB_SANITIZED
constexpr int drawn_per_family = 400, moved_per_gap = 40;
#else
constexpr int drawn_per_family = 80'000, moved_per_gap = 7'800;
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
    long touching = 0;  // verdicts, although the search shows a clear gap or depth
    long unproven = 0, contrary = 0;
    std::string first;  // of the last two

    Agreement& operator+=(const Agreement& other) {
        pairs += other.pairs;
        apart += other.apart;
        meeting += other.meeting;
        open += other.open;
        touching += other.touching;
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

Agreement compare(const ScbPair& pair) {
    const Scb &a = pair.a, b = placed(pair.b, pair.b_to_a);
    const double larger = std::max(a.r, b.r);
    const ContactProof proof = exact_overlap(a, b);
    const SupportBounds shown = search_supports(a, b, clearly_apart * larger,
                                                {clearly_deep * larger, least_depth * larger});
    Agreement result;
    result.pairs = 1;
    result.unproven = proof.contact != Contact::touching && !verify(a, b, proof);
    if (shown.lower > least_gap * larger) {
        result.apart = 1;
        result.contrary = proof.contact == Contact::overlapping;
        result.touching =
            proof.contact == Contact::touching && shown.lower > clearly_apart * larger;
    } else if (shown.depth > 0) {
        result.meeting = 1;
        result.contrary = proof.contact == Contact::disjoint;
        result.touching =
            proof.contact == Contact::touching && shown.depth >= clearly_deep * larger;
    } else {
        result.open = 1;
    }
    // Whatever was shown, a plane and a point of both exclude each other.
    result.contrary |= proof.contact == Contact::disjoint && proof.margin > shown.upper + 1e-13;
    if (result.unproven + result.contrary > 0) result.first = to_text(a, b);
    return result;
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
