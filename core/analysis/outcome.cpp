#include "core/analysis/outcome.h"

#include <algorithm>

namespace scb {

std::string_view outcome_name(Outcome outcome) {
    switch (outcome) {
        case Outcome::triangles_apart:
            return "triangles apart";
        case Outcome::triangles_meet:
            return "triangles meet";
        case Outcome::found:
            return "found";
        case Outcome::neighbors:
            return "neighbors";
        case Outcome::left_over:
            return "left over";
        case Outcome::divided_a:
            return "divided a";
        case Outcome::divided_b:
            return "divided b";
        case Outcome::divided_both:
            return "divided both";
    }
    return stage_name(static_cast<Stage>(outcome));
}

Outcomes outcomes_of(const Steps& steps, std::span<const IndexPair> found_nodes) {
    const std::vector<Step>& tests = steps.volumes;
    Outcomes outcomes;
    outcomes.reserve(tests.size());
    for (const Step& test : tests)
        outcomes.push_back(test.stage != Stage::overlapping ? rejected_at(test.stage)
                           : std::binary_search(found_nodes.begin(), found_nodes.end(), test.nodes)
                               ? Outcome::found
                               : Outcome::left_over);
    for (const Step& test : tests) {
        if (test.parent == no_step) continue;
        Outcome& parent = outcomes[test.parent];
        if (parent != Outcome::left_over && !is_divided(parent)) continue;
        const IndexPair nodes = test.nodes, above = tests[test.parent].nodes;
        const Outcome divided = nodes.a == above.a   ? Outcome::divided_b
                                : nodes.b == above.b ? Outcome::divided_a
                                                     : Outcome::divided_both;
        parent =
            parent == Outcome::left_over || parent == divided ? divided : Outcome::divided_both;
    }
    for (const ItemStep& test : steps.items) {
        Outcome& leaves = outcomes[test.step];
        if (is_rejection(leaves)) continue;  // the engine contradicts itself
        if (test.hit)
            leaves = Outcome::triangles_meet;
        else if (leaves != Outcome::triangles_meet)
            leaves = test.neighbors ? Outcome::neighbors : Outcome::triangles_apart;
    }
    return outcomes;
}

}  // namespace scb
