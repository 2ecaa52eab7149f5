#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/study/explained_pair.h"
#include "scenes/recordings/recorded_trace.h"

namespace scb::app {

/// A recorded test of two nodes.
struct FoundTest {
    std::size_t number = 0;             ///< index among the volume tests of its query
    Stage stage = Stage::overlapping;   ///< of the test
    std::optional<std::size_t> led_by;  ///< the test that led to it, if known
    Answer answer = Answer::correct;
};

/// Two nodes of a recording at a frame, and the tests of them.
struct RecordedPair {
    const scenes::RecordedTrace* trace = nullptr;
    const QueryTrace* frame = nullptr;
    IndexPair nodes;  ///< indices
    std::vector<FoundTest> tests;
    ExplainedPair pair;
    bool has_verdict = false;

    const TraceHeader& header() const { return trace->header(); }
    bool has_wrong_test() const {
        return std::any_of(tests.begin(), tests.end(), [](const FoundTest& test) {
            return test.answer == Answer::false_negative;
        });
    }
};

/// Two nodes, by the engine's numbers, at a frame of the trace. Frames must be requested in
/// ascending order. Throws InputError if a node does not exist or has no volume; `option`: the
/// option that named them.
RecordedPair recorded_pair(scenes::RecordedTrace& trace, int frame, IndexPair numbers,
                           const std::string& option);

}  // namespace scb::app
