#pragma once

#include <string>
#include <vector>

#include "core/base/enum_names.h"
#include "core/explain/exact_overlap.h"
#include "core/explain/overlap_steps.h"
#include "scb/volume.h"

namespace scb {

/// The verdict on an overlap test's answer about two volumes.
enum class Answer {
    correct,         ///< also any answer about volumes that touch
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
    OverlapSteps steps;             ///< of the test of the options
    Answer answer{};                ///< the verdict on this test
    std::vector<TestAnswer> tests;  ///< all tests for slab cut balls; empty for other volumes
    /// The certificate of exact_verdict, sharpened; in A's frame.
    ContactCertificate certificate;
    /// Whether `verify` confirms the verdict before it was sharpened, and check_certificate the
    /// certificate.
    bool verified = false;
};

/// Explains the test that the options name, for A in its own frame and B in the frame that `placed`
/// places. The volumes must be well-formed. The exact verdict takes microseconds, its sharpening up
/// to a millisecond.
template <Volume V>
PairExplanation explain(const V& a, const V& b, const Placement& placed,
                        const OverlapOptions& options = {});

}  // namespace scb
