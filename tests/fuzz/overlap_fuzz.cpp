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

Scb2 with_second_slab(const Scb& s, fuzz::Numbers& numbers) {
    const auto share = [&] { return std::abs(numbers.raw<std::int8_t>() / 128.0); };
    const Vec3 first = s.n / std::sqrt(squared_norm(s.n));
    Vec3 n = numbers.direction();
    for (int i = 0; i < 2; ++i) {
        n -= dot(first, n) * first;
        n /= std::sqrt(squared_norm(n));
    }
    return {s.c,
            s.r,
            {Slab{first, std::max(s.e, 0.0), std::min(s.f, 0.0)},
             Slab{n, s.r * share(), -s.r * share()}}};
}

// No conservative test rejects a pair that a certificate proves to overlap.
SCB_FUZZ(input) {
    fuzz::Numbers numbers(input);
    const Scb a = any_scb(numbers), b = any_scb(numbers);
    if (!is_well_formed(a) || !is_well_formed(b)) return;
    const ContactCertificate certificate = exact_overlap(a, b);
    const Pose identity;
    const Scb2 two_a = with_second_slab(a, numbers), two_b = with_second_slab(b, numbers);
    if (is_well_formed(two_a) && is_well_formed(two_b)) {
        const Contact contact = exact_overlap(two_a, two_b).contact;
        fuzz::require(overlap(two_a, two_b, identity) == Stage::overlapping ||
                          contact != Contact::overlapping,
                      "the test of two slabs passes what overlaps");
    }
    for (const OverlapTest test : all_overlap_tests()) {
        if (!is_sound(test)) continue;
        const OverlapOptions options{test, numbers.below(11) / 10.0};
        const bool passed = overlap(a, b, identity, options) == Stage::overlapping;
        fuzz::require(passed || certificate.contact != Contact::overlapping,
                      "a conservative test passes volumes that overlap");
        fuzz::require(passed == (overlap(b, a, identity, options) == Stage::overlapping) ||
                          test != OverlapTest::symmetric,
                      "the symmetric test is symmetric");
    }
}
