#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// What another overlap test makes of a query, or of several.
struct AlternativeTest {
    OverlapOptions overlap;
    std::uint64_t caught = 0;  ///< pairs that passed because of a weak test, which this one rejects
    std::uint64_t pairs = 0;   ///< that the whole query finds with it
    Work all;                  ///< that the whole query takes with it

    void add(const AlternativeTest& other);
};

/// The tests that could be taken in place of the trace's one: `symmetric`, `extents`, and
/// `corrected` with its threshold at several places (`line8` differs from it only by rejecting
/// less). None for other volumes than slab cut balls.
std::vector<OverlapOptions> alternative_tests(const TraceHeader& header);

/// Makes the query again with another test. The hierarchies are of the header's kind.
AlternativeTest try_alternative_test(const AnyHierarchy& a, const Mesh& mesh_a,
                                     const AnyHierarchy& b, const Mesh& mesh_b,
                                     const TraceHeader& header, const TraceFrame& frame,
                                     const Attribution& attribution, const OverlapOptions& other);

}  // namespace scb
