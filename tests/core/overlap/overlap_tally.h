#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/explain/exact_overlap.h"
#include "scb/overlap.h"
#include "tests/core/overlap/random_scb_pairs.h"

namespace scb {

inline constexpr std::size_t overlap_test_count = 5;

/// Results of the overlap tests on many pairs of one family, compared with the exact test.
struct OverlapTally {
    /// Pairs by exact verdict and by which tests rejected them: bit k for the test numbered k.
    std::array<std::array<std::uint64_t, 1u << overlap_test_count>, 3> pairs{};
    /// Pairs whose certificate did not stand up to its checker.
    std::uint64_t unproven = 0;
    /// The first pair that a test rejected although it overlaps, as drawn.
    std::array<std::optional<ScbPair>, overlap_test_count> wrongly_rejected;
    /// Processor time.
    std::array<double, overlap_test_count> test_seconds{};
    double exact_seconds = 0;

    OverlapTally& operator+=(const OverlapTally& other);
};

/// Draws the pairs from the seed and asks every test.
OverlapTally tally_overlap_tests(const ScbPairFamily& family, std::uint64_t seed,
                                 std::uint64_t pairs);

/// How many pairs have the verdict; how many of them the test rejected; how many of any verdict
/// `one` rejected and `other` did not.
std::uint64_t count(const OverlapTally& tally, Contact contact);
std::uint64_t count_rejected(const OverlapTally& tally, Contact contact, OverlapTest test);
std::uint64_t count_rejected_by_one(const OverlapTally& tally, OverlapTest one, OverlapTest other);

/// Prints a row per test: pairs, certified verdicts, wrong rejections, share of false positives
/// among the disjoint pairs, time.
void print_tally(std::string_view name, const OverlapTally& tally);
void print_tally_header();

}  // namespace scb
