#include "core/analysis/trace_prefix.h"

#include <algorithm>
#include <numeric>

#include "core/analysis/traversal_part.h"

namespace scb {

QueryTrace trace_prefix(const TraceHeader& header, const QueryTrace& frame, std::size_t count) {
    const std::size_t all = frame.steps.volumes.size();
    std::vector<std::uint32_t> first(std::min(count, all));
    std::iota(first.begin(), first.end(), 0u);
    QueryTrace result = with_tests(header, frame, first);
    result.found.complete = first.size() == all && frame.found.complete;
    return result;
}

}  // namespace scb
