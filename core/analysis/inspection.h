#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// The volume tests of pairs at one depth: the depths of both nodes added.
struct DepthInspection {
    std::uint64_t tests = 0;
    WastedTests wasted;                                     ///< of these, tests below a false pair
    std::array<std::uint64_t, pass_reason_count> passed{};  ///< passed pairs by reason
};

/// The passed pairs and the wasted work of a query, or of several together.
struct Inspection {
    std::uint64_t pairs = 0;  ///< pairs that were found
    PassCounts counts;
    std::vector<DepthInspection> depths;  ///< from 0

    Inspection& operator+=(const Inspection& other);
};

/// The inspection of one query.
Inspection inspection(const QueryTrace& frame, const Attribution& attribution);

/// One frame of several.
struct InspectedFrame {
    int frame = 0;
    Inspection found;
    /// Of a query for the smallest distance: the distance that it found, or a negative number.
    double distance = -1;
    bool certified = false;  ///< whether a certificate proves the distance
};

/// Puts the frame with the most wasted volume tests first; equal frames by number.
void sort_by_waste(std::vector<InspectedFrame>& frames);

}  // namespace scb
