#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// The result of a query, or of several, with another overlap test.
struct AlternativeTest {
    OverlapOptions overlap;
    std::uint64_t caught = 0;  ///< pairs that a weak test passed and this test rejects
    std::uint64_t pairs = 0;   ///< pairs that the whole query finds with this test
    Work all;                  ///< work of the whole query with this test

    void add(const AlternativeTest& other);
};

/// The tests to try in place of the trace's test: `symmetric`, `extents`, and `corrected` with
/// several thresholds (`line8` only rejects less than `corrected`). Empty for volumes other than
/// slab cut balls.
std::vector<OverlapOptions> alternative_tests(const TraceHeader& header);

/// Repeats the query with another test. The hierarchies must be of the header's volume kind.
AlternativeTest try_alternative_test(const AnyHierarchy& a, const Mesh& mesh_a,
                                     const AnyHierarchy& b, const Mesh& mesh_b,
                                     const TraceHeader& header, const QueryTrace& frame,
                                     const Attribution& attribution, const OverlapOptions& other);

}  // namespace scb
