// overlap_soundness [--slabs 1|2] [--pairs N] [--seed S] [--threads T]: asks every overlap test of
// slab cut balls about N random pairs of each family in random_scb_pairs.h, and the overlap test of
// two slabs about N pairs of each family in scb2_pairs.h (--slabs: only one of the two). Compares
// the answers with certified ones; with two slabs, only every hundredth pair that passes. Except
// the times, the figures depend on N and S only. Exit status 1 if a conservative test has rejected
// an overlapping pair, or if a certificate was not valid.

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/core/overlap/overlap_tally.h"
#include "tests/core/overlap/scb2_tally.h"

namespace {

using namespace scb;

constexpr std::uint64_t chunk = 1u << 16;

struct Arguments {
    std::uint64_t pairs = 1000000, seed = 1, threads = std::thread::hardware_concurrency();
    std::uint64_t slabs = 0;  // 0: of one and of two
};

bool parse(int count, char** values, Arguments& arguments) {
    for (int i = 1; i < count; i += 2) {
        std::uint64_t* target = std::strcmp(values[i], "--pairs") == 0     ? &arguments.pairs
                                : std::strcmp(values[i], "--seed") == 0    ? &arguments.seed
                                : std::strcmp(values[i], "--threads") == 0 ? &arguments.threads
                                : std::strcmp(values[i], "--slabs") == 0   ? &arguments.slabs
                                                                           : nullptr;
        if (target == nullptr || i + 1 == count) return false;
        const char* end = values[i + 1] + std::strlen(values[i + 1]);
        const auto [rest, error] = std::from_chars(values[i + 1], end, *target);
        if (error != std::errc{} || rest != end) return false;
    }
    arguments.threads = std::max<std::uint64_t>(arguments.threads, 1);
    return arguments.slabs <= 2;
}

// Chunk by chunk, each from a seed of its own, so that the threads can share them in any order.
template <class Tally, class Draw>
Tally tally_family(std::size_t family, const Arguments& arguments, const Draw& draw) {
    Tally tally;
    std::mutex mutex;
    std::atomic<std::uint64_t> next = 0;
    const auto work = [&] {
        Tally own;
        for (std::uint64_t i; (i = chunk * next++) < arguments.pairs;) {
            const std::uint64_t seed =
                Random(arguments.seed ^ Random(i + family + 1).next()).next();
            own += draw(seed, std::min(chunk, arguments.pairs - i));
        }
        const std::lock_guard lock(mutex);
        tally += own;
    };
    std::vector<std::thread> threads;
    for (std::uint64_t t = 1; t < arguments.threads; ++t) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    return tally;
}

bool one_slab_is_sound(const Arguments& arguments) {
    print_tally_header();
    OverlapTally sum;
    for (std::size_t k = 0; k < scb_pair_families.size(); ++k) {
        const auto tally =
            tally_family<OverlapTally>(k, arguments, [&](std::uint64_t seed, std::uint64_t pairs) {
                return tally_overlap_tests(scb_pair_families[k], seed, pairs);
            });
        print_tally(scb_pair_families[k].name, tally);
        std::fflush(stdout);
        sum += tally;
    }
    print_tally("all", sum);
    const auto report = [&](OverlapTest one, OverlapTest other) {
        const std::string_view a = overlap_test_name(one), b = overlap_test_name(other);
        std::printf("rejected by %.*s but not by %.*s: %" PRIu64 "\n", static_cast<int>(a.size()),
                    a.data(), static_cast<int>(b.size()), b.data(),
                    count_rejected_by_one(sum, one, other));
    };
    report(OverlapTest::corrected, OverlapTest::symmetric);
    report(OverlapTest::symmetric, OverlapTest::extents);
    bool correct = sum.unproven == 0;
    for (const OverlapTest test :
         {OverlapTest::line8, OverlapTest::corrected, OverlapTest::symmetric, OverlapTest::extents})
        correct = correct && count_rejected(sum, Contact::overlapping, test) == 0;
    return correct;
}

bool two_slabs_are_sound(const Arguments& arguments) {
    print_scb2_tally_header();
    Scb2Tally sum;
    for (std::size_t k = 0; k < scb2_pair_families.size(); ++k) {
        const Scb2PairFamily& family = scb2_pair_families[k];
        const auto tally =
            tally_family<Scb2Tally>(k, arguments, [&](std::uint64_t seed, std::uint64_t pairs) {
                return tally_scb2(family, seed, pairs, 100);
            });
        print_tally(family.name, tally);
        std::fflush(stdout);
        sum += tally;
    }
    print_tally("all", sum);
    return !sum.wrongly_rejected && sum.unproven == 0;
}

}  // namespace

int main(int count, char** values) {
    Arguments arguments;
    if (!parse(count, values, arguments)) {
        std::fprintf(
            stderr,
            "usage: overlap_soundness [--slabs 1|2] [--pairs N] [--seed S] [--threads T]\n");
        return 2;
    }
    std::printf("%" PRIu64 " pairs of each family, seed %" PRIu64 "\n", arguments.pairs,
                arguments.seed);
    const bool one_slab = arguments.slabs == 2 || one_slab_is_sound(arguments);
    const bool two_slabs = arguments.slabs == 1 || two_slabs_are_sound(arguments);
    return one_slab && two_slabs ? 0 : 1;
}
