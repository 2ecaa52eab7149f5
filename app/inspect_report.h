#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/inspection.h"

namespace scb {

/// One frame of an inspection.
struct InspectedFrame {
    int frame = 0;
    Inspection found;
};

/// Everything that `scb inspect` found.
struct InspectReport {
    TraceHeader header;
    std::vector<InspectedFrame> frames;  ///< the one with the most wasted tests first
    Inspection sum;
    std::vector<FalsePair> weak_tests, loose_fits;  ///< the worst ones
    std::vector<OtherTest> others;

    /// Puts the frames in order, and adds them up.
    void finish();
};

/// As tables for a reader.
std::string inspect_text(const InspectReport& report);

/// Everything, in the paper's language. Beside the header of a trace: `frames`, `sum`, `depths`,
/// `worst`, `other_tests`.
nlohmann::ordered_json inspect_json(const InspectReport& report);

/// The frames, or the worst pairs, a line each.
std::string inspect_frames_csv(const InspectReport& report);
std::string inspect_pairs_csv(const InspectReport& report);

}  // namespace scb
