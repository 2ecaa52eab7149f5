#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/explain/contact_certificate.h"
#include "scb/stage.h"
#include "tests/core/overlap/scb2_pairs.h"

namespace scb {

/// Results of the overlap test of two slabs on many pairs of one family, compared with certified
/// verdicts.
struct Scb2Tally {
    /// Pairs by exact verdict; of those, the ones that the test rejected.
    std::array<std::uint64_t, 3> pairs{}, rejected{};
    StageCounts stages{};
    std::uint64_t every = 1;  ///< of pairs that passed, so many stand behind each that is counted
    std::uint64_t unproven = 0;  ///< certificates that did not stand up to their checkers
    std::optional<VolumePair<Scb2>> wrongly_rejected;  ///< the first, as drawn

    Scb2Tally& operator+=(const Scb2Tally& other);
};

/// Draws the pairs from the seed and asks the test. The exact verdict is asked for where the test
/// rejects, and of every `every`-th of the other pairs, which alone are counted of these.
Scb2Tally tally_scb2(const Scb2PairFamily& family, std::uint64_t seed, std::uint64_t pairs,
                     std::uint64_t every = 1);

/// Prints a row: pairs, verdicts, wrong rejections, and the share of false positives among the
/// disjoint pairs, those that passed taken as often as they stand for others.
void print_tally(std::string_view name, const Scb2Tally& tally);
void print_scb2_tally_header();

}  // namespace scb
