#pragma once

#include <string>
#include <vector>

#include "core/base/enum_names.h"
#include "core/explain/exact_verdict.h"
#include "core/explain/overlap_steps.h"
#include "scb/volume.h"

namespace scb {

/// What an overlap test's answer about two volumes is worth.
enum class Answer {
    correct,         ///< also of volumes that touch, whichever it is
    false_positive,  ///< the test let volumes pass that are disjoint: it is conservative
    false_negative,  ///< the test rejected volumes that overlap: it misses collisions
};

inline constexpr EnumNames<Answer, 3> answer_names = {"correct", "false positive",
                                                      "false negative"};

/// How a test ended, in words: "rejected at slab-cylinder", "passed".
std::string ending_words(Stage stage);

/// Judges the stage at which a test ended by the exact contact of the two volumes.
Answer judged(Stage stage, Contact contact);

/// How one of the tests for slab cut balls ends.
struct TestAnswer {
    OverlapTest test{};
    Stage stage = Stage::overlapping;
    Answer answer = Answer::correct;
};

/// One overlap test, and whether it is right.
struct PairExplanation {
    OverlapSteps steps;             ///< of the test that was asked for
    Answer answer{};                ///< that test's
    std::vector<TestAnswer> tests;  ///< all tests for slab cut balls; empty for other volumes
    /// That of exact_verdict, sharpened; in A's frame.
    ContactCertificate certificate;
    /// What `verify` says of the verdict before it was sharpened, and check_certificate of the
    /// certificate.
    bool verified = false;
};

/// Explains the test that the options name, for A in its own frame and B in the one that `placed`
/// says where it is. The volumes must be well-formed. The exact verdict takes microseconds, its
/// sharpening up to a millisecond.
template <Volume V>
PairExplanation explain(const V& a, const V& b, const Placement& placed,
                        const OverlapOptions& options = {});

}  // namespace scb
