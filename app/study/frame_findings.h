#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/study/query_source.h"
#include "core/analysis/alternative_test.h"
#include "core/analysis/inspection.h"
#include "core/analysis/tested_triangles.h"
#include "core/analysis/waste_causes.h"
#include "core/analysis/worst_pairs.h"

namespace scb::app {

/// The findings of `scb inspect` in one frame, or in several that were added.
struct FrameFindings {
    std::vector<InspectedFrame> frames;
    bool complete = true;  ///< whether no query ended at its limit of pairs
    VainTests vain;
    /// Of A and of B; in a self query all of A. None for objects of another engine.
    std::array<std::vector<TestedTriangle>, 2> tested;
    std::vector<WorstPairs> worst;  ///< by waste_reasons
    WorstRejections wrong;
    std::vector<AlternativeTest> others;  ///< see alternative_tests

    /// No frame yet; lists have at most `top` pairs.
    FrameFindings(const TraceHeader& header, std::size_t top);
    /// Adds a frame of the source, with the attribution of its tests.
    void add(const QuerySource& source, const QueryTrace& frame, const Attribution& attribution);
    /// Adds later frames.
    FrameFindings& operator+=(const FrameFindings& other);
};

/// For the file of a shard.
nlohmann::ordered_json findings_json(const FrameFindings& findings);
/// The findings of one frame of the source. Throws the JSON library's exceptions if the JSON is not
/// from findings_json, or its numbers are not from this query.
FrameFindings findings_of_json(const nlohmann::ordered_json& json, const QuerySource& source,
                               int frame, std::size_t top);

}  // namespace scb::app
