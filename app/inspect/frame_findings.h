#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/query/query_source.h"
#include "core/analysis/alternative_test.h"
#include "core/analysis/inspection.h"
#include "core/analysis/waste_causes.h"
#include "core/analysis/worst_pairs.h"

namespace scb::app {

/// What `scb inspect` finds in frames: in one, or in several that were added.
struct FrameFindings {
    std::vector<InspectedFrame> frames;
    bool complete = true;  ///< whether no query ended at the pairs that it may find at most
    VainTests vain;
    WorstPairs weak_tests, loose_fits;
    WorstRejections wrong;
    std::vector<AlternativeTest> others;  ///< see alternative_tests

    /// Of no frame yet; lists have at most `top` pairs.
    FrameFindings(const TraceHeader& header, std::size_t top);
    /// Those of a frame of the source that was asked for last.
    void add(QuerySource& source, const TraceFrame& frame);
    /// Those of other frames, which come after these.
    FrameFindings& operator+=(const FrameFindings& other);
};

/// For the file of a shard.
nlohmann::ordered_json findings_json(const FrameFindings& findings);
/// Those of one frame of the source. Throws what the JSON library throws for JSON that
/// findings_json did not write, or numbers that are not of this query.
FrameFindings findings_of_json(const nlohmann::ordered_json& json, const QuerySource& source,
                               int frame, std::size_t top);

}  // namespace scb::app
