#include "core/explain/exact_overlap.h"
#include "scb/overlap.h"
#include "scb/placement.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

namespace {

Scb any_scb(fuzz::Numbers& numbers) {
    Scb scb;
    scb.c = numbers.point();
    scb.r = std::abs(numbers.coordinate());
    scb.n = numbers.direction();
    const double a = numbers.raw<std::int8_t>() / 127.0, b = numbers.raw<std::int8_t>() / 127.0;
    scb.f = scb.r * std::max(-1.0, std::min(a, b));
    scb.e = scb.r * std::max(-1.0, std::max(a, b));
    return scb;
}

}  // namespace

// No sound test rejects a pair of which a certificate proves that it overlaps.
SCB_FUZZ(input) {
    fuzz::Numbers numbers(input);
    const Scb a = any_scb(numbers), b = any_scb(numbers);
    if (!is_well_formed(a) || !is_well_formed(b)) return;
    const ContactCertificate certificate = exact_overlap(a, b);
    const Pose identity;
    for (const OverlapTest test : all_overlap_tests()) {
        if (!is_sound(test)) continue;
        const OverlapOptions options{test, numbers.below(11) / 10.0};
        const bool passed = overlap(a, b, identity, options) == Stage::overlapping;
        fuzz::require(passed || certificate.contact != Contact::overlapping,
                      "a sound test passes what overlaps");
        fuzz::require(passed == (overlap(b, a, identity, options) == Stage::overlapping) ||
                          test != OverlapTest::symmetric,
                      "the symmetric test is symmetric");
    }
}
