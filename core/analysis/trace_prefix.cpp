#include "core/analysis/trace_prefix.h"

#include <algorithm>

namespace scb {

TraceFrame trace_prefix(const TraceHeader& header, const TraceFrame& frame,
                        const TraversalTree& tree, std::size_t count) {
    TraceFrame result{frame.frame, frame.b_to_a, {}, {}};
    const auto& tests = frame.events.volume_tests;
    count = std::min(count, tests.size());
    Collision& found = result.found;
    for (std::size_t i = 0; i < count; ++i) {
        ++found.stages[static_cast<std::size_t>(tests[i].stage)];
        found.depth = std::max(found.depth, tests[i].depth_a + tests[i].depth_b);
        if (tree.outcomes[i] == Outcome::found) found.pairs.push_back(tests[i].nodes);
    }
    result.events.volume_tests.assign(tests.begin(),
                                      tests.begin() + static_cast<std::ptrdiff_t>(count));
    for (const TriangleTest& test : frame.events.triangle_tests) {
        if (test.after >= count) break;
        result.events.triangle_tests.push_back(test);
        ++found.n_p;
        if (test.intersect) found.pairs.push_back(test.triangles);
    }
    found.n_v = count;
    found.n_u = transform_count(header.volume, found.stages, header.options.overlap);
    found.complete = count == tests.size() && frame.found.complete;
    std::sort(found.pairs.begin(), found.pairs.end());
    return result;
}

}  // namespace scb
