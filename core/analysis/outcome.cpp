#include "core/analysis/outcome.h"

#include <algorithm>

namespace scb {

Outcomes outcomes_of(const Steps& steps, std::span<const IndexPair> found_nodes) {
    const std::vector<Step>& tests = steps.volumes;
    Outcomes outcomes;
    outcomes.reserve(tests.size());
    for (const Step& test : tests)
        outcomes.push_back(test.stage != Stage::overlapping ? test.stage
                           : std::binary_search(found_nodes.begin(), found_nodes.end(), test.nodes)
                               ? Stage::found
                               : Stage::left_over);
    for (const Step& test : tests) {
        if (test.parent == no_step) continue;
        Stage& parent = outcomes[test.parent];
        if (parent != Stage::left_over && !is_divided(parent)) continue;
        const IndexPair nodes = test.nodes, above = tests[test.parent].nodes;
        const Stage divided = nodes.a == above.a   ? Stage::divided_b
                              : nodes.b == above.b ? Stage::divided_a
                                                   : Stage::divided_both;
        parent = parent == Stage::left_over || parent == divided ? divided : Stage::divided_both;
    }
    for (const ItemStep& test : steps.items) {
        Stage& leaves = outcomes[test.step];
        if (is_rejection(leaves)) continue;  // the engine contradicts itself
        if (test.hit)
            leaves = Stage::triangles_meet;
        else if (leaves != Stage::triangles_meet)
            leaves = test.neighbors ? Stage::neighbors : Stage::triangles_apart;
    }
    return outcomes;
}

}  // namespace scb
