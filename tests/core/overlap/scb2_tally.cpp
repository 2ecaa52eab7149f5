#include "tests/core/overlap/scb2_tally.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include "core/explain/contact_certificate.h"
#include "core/explain/exact_overlap.h"
#include "scb/overlap.h"

namespace scb {
namespace {

std::uint64_t of(const std::array<std::uint64_t, 3>& counts, Contact contact) {
    return counts[static_cast<std::size_t>(contact)];
}

}  // namespace

Scb2Tally& Scb2Tally::operator+=(const Scb2Tally& other) {
    for (std::size_t i = 0; i < 3; ++i) {
        pairs[i] += other.pairs[i];
        rejected[i] += other.rejected[i];
    }
    for (std::size_t i = 0; i < stage_count; ++i) stages[i] += other.stages[i];
    every = std::max(every, other.every);
    unproven += other.unproven;
    if (!wrongly_rejected) wrongly_rejected = other.wrongly_rejected;
    return *this;
}

Scb2Tally tally_scb2(const Scb2PairFamily& family, std::uint64_t seed, std::uint64_t pairs,
                     std::uint64_t every) {
    Random random(seed);
    Scb2Tally tally;
    tally.every = every;
    for (std::uint64_t i = 0; i < pairs; ++i) {
        const VolumePair<Scb2> pair = random_scb2_pair(random, family);
        const Stage stage = overlap(pair.a, pair.b, pair.b_to_a);
        ++tally.stages[static_cast<std::size_t>(stage)];
        const bool rejected = stage != Stage::overlapping;
        if (!rejected && i % every != 0) continue;
        const Placement placed = placement(pair.b_to_a, reach(pair.a), reach(pair.b));
        const ContactCertificate verdict = exact_verdict(pair.a, pair.b, placed);
        const auto contact = static_cast<std::size_t>(verdict.contact);
        ++tally.pairs[contact];
        tally.rejected[contact] += rejected;
        if (verdict.contact != Contact::touching) {
            const Scb2 in_a = seen_from_a(pair.b, placed);
            tally.unproven +=
                !verify(pair.a, in_a, verdict) || !check_certificate(pair.a, in_a, verdict);
        }
        if (rejected && verdict.contact == Contact::overlapping && !tally.wrongly_rejected)
            tally.wrongly_rejected = pair;
    }
    return tally;
}

void print_scb2_tally_header() {
    std::printf("%-30s %12s %12s %9s %9s %9s %10s\n", "two slabs", "disjoint", "overlapping",
                "touching", "unproven", "wrong", "false pos.");
}

void print_tally(std::string_view name, const Scb2Tally& t) {
    const std::uint64_t disjoint = of(t.pairs, Contact::disjoint),
                        rejected = of(t.rejected, Contact::disjoint);
    const auto passed = static_cast<double>((disjoint - rejected) * t.every);
    std::printf(
        "%-30.*s %12" PRIu64 " %12" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9.3f%%\n",
        static_cast<int>(name.size()), name.data(), disjoint, of(t.pairs, Contact::overlapping),
        of(t.pairs, Contact::touching), t.unproven, of(t.rejected, Contact::overlapping),
        disjoint == 0 ? 0.0 : 100 * passed / (passed + static_cast<double>(rejected)));
}

}  // namespace scb
