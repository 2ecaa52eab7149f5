#include "tests/core/overlap/overlap_tally.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <ctime>
#include <vector>

#include "core/overlap/test_functors.h"

namespace scb {
namespace {

// Small enough to stay in the cache, large enough for the clock.
constexpr std::uint64_t batch_size = 512;

struct Drawn {
    ScbPair pair;
    Scb b_in_a;
    Placement placed;
    ContactCertificate certificate;
    unsigned rejected = 0;
};

// Of the thread, so that a busy machine does not count.
double processor_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void ask_exact_test(std::span<Drawn> batch, OverlapTally& tally) {
    const double start = processor_seconds();
    for (Drawn& d : batch) d.certificate = exact_overlap(d.pair.a, d.b_in_a, 1e-13);
    tally.exact_seconds += processor_seconds() - start;
    for (const Drawn& d : batch)
        tally.unproven += d.certificate.contact != Contact::touching &&
                          !verify(d.pair.a, d.b_in_a, d.certificate);
}

void ask_test(OverlapTest test, std::span<Drawn> batch, OverlapTally& tally) {
    const auto index = static_cast<unsigned>(test);
    const double start = processor_seconds();
    with_overlap_test<Scb>({.test = test}, [&](auto overlaps) {
        for (Drawn& d : batch)
            if (overlaps(d.pair.a, d.pair.b, d.placed) != Stage::overlapping)
                d.rejected |= 1u << index;
    });
    tally.test_seconds[index] += processor_seconds() - start;
}

bool is_rejected(std::size_t mask, OverlapTest test) {
    return mask >> static_cast<unsigned>(test) & 1;
}

double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

OverlapTally& OverlapTally::operator+=(const OverlapTally& other) {
    for (std::size_t c = 0; c < pairs.size(); ++c)
        for (std::size_t mask = 0; mask < pairs[c].size(); ++mask)
            pairs[c][mask] += other.pairs[c][mask];
    unproven += other.unproven;
    for (std::size_t k = 0; k < overlap_test_count; ++k) {
        if (!wrongly_rejected[k]) wrongly_rejected[k] = other.wrongly_rejected[k];
        test_seconds[k] += other.test_seconds[k];
    }
    exact_seconds += other.exact_seconds;
    return *this;
}

OverlapTally tally_overlap_tests(const ScbPairFamily& family, std::uint64_t seed,
                                 std::uint64_t pairs) {
    OverlapTally tally;
    Random random(seed);
    std::vector<Drawn> batch;
    for (std::uint64_t done = 0; done < pairs; done += batch.size()) {
        batch.assign(std::min(batch_size, pairs - done), {});
        for (Drawn& d : batch) {
            d.pair = random_scb_pair(random, family);
            d.b_in_a = placed(d.pair.b, d.pair.b_to_a);
            d.placed = placement(d.pair.b_to_a, reach(d.pair.a), reach(d.pair.b));
        }
        ask_exact_test(batch, tally);
        for (const OverlapTest test : all_overlap_tests()) ask_test(test, batch, tally);
        for (const Drawn& d : batch) {
            ++tally.pairs[static_cast<std::size_t>(d.certificate.contact)][d.rejected];
            if (d.certificate.contact != Contact::overlapping) continue;
            for (std::size_t k = 0; k < overlap_test_count; ++k)
                if ((d.rejected >> k & 1) && !tally.wrongly_rejected[k])
                    tally.wrongly_rejected[k] = d.pair;
        }
    }
    return tally;
}

std::uint64_t count(const OverlapTally& tally, Contact contact) {
    std::uint64_t sum = 0;
    for (const std::uint64_t n : tally.pairs[static_cast<std::size_t>(contact)]) sum += n;
    return sum;
}

std::uint64_t count_rejected(const OverlapTally& tally, Contact contact, OverlapTest test) {
    const auto& by_mask = tally.pairs[static_cast<std::size_t>(contact)];
    std::uint64_t sum = 0;
    for (std::size_t mask = 0; mask < by_mask.size(); ++mask)
        if (is_rejected(mask, test)) sum += by_mask[mask];
    return sum;
}

std::uint64_t count_rejected_by_one(const OverlapTally& tally, OverlapTest one, OverlapTest other) {
    std::uint64_t sum = 0;
    for (const auto& by_mask : tally.pairs)
        for (std::size_t mask = 0; mask < by_mask.size(); ++mask)
            if (is_rejected(mask, one) && !is_rejected(mask, other)) sum += by_mask[mask];
    return sum;
}

void print_tally_header() {
    std::printf("%-34s %-10s %11s %11s %11s %9s %9s %10s %9s\n", "family", "test", "pairs",
                "overlapping", "disjoint", "undecided", "wrong", "false pos.", "ns");
}

void print_tally(std::string_view name, const OverlapTally& tally) {
    const std::uint64_t overlapping = count(tally, Contact::overlapping),
                        disjoint = count(tally, Contact::disjoint),
                        undecided = count(tally, Contact::touching),
                        all = overlapping + disjoint + undecided;
    const auto nanoseconds = [&](double seconds) {
        return all == 0 ? 0 : 1e9 * seconds / static_cast<double>(all);
    };
    std::printf("%-34.*s %-10s %11" PRIu64 " %11" PRIu64 " %11" PRIu64 " %9" PRIu64 " %9" PRIu64
                " %10s %9.0f\n",
                static_cast<int>(name.size()), name.data(), "exact", all, overlapping, disjoint,
                undecided, tally.unproven, "", nanoseconds(tally.exact_seconds));
    for (const OverlapTest test : all_overlap_tests()) {
        const std::string_view test_name = overlap_test_name(test);
        std::printf(
            "%-34s %-10.*s %11s %11s %11s %9s %9" PRIu64 " %8.3f %% %9.1f\n", "",
            static_cast<int>(test_name.size()), test_name.data(), "", "", "", "",
            count_rejected(tally, Contact::overlapping, test),
            100 * share(disjoint - count_rejected(tally, Contact::disjoint, test), disjoint),
            nanoseconds(tally.test_seconds[static_cast<std::size_t>(test)]));
    }
}

}  // namespace scb
