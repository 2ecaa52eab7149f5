#include "core/judge/division_check.h"

#include <algorithm>
#include <set>

namespace scb {
namespace {

std::vector<std::uint32_t> children_of(const TreeShape& shape, std::uint32_t node) {
    std::vector<std::uint32_t> children;
    for (std::uint32_t child = shape.first_child[node]; child != no_index;
         child = shape.next_sibling[child])
        children.push_back(child);
    return children;
}

/// What a test led to: which children of A's node and of B's were tested.
struct Division {
    std::set<std::uint32_t> of_a, of_b;
    std::size_t pairs = 0;  ///< of a child of each
};

bool overlap(const EngineQuery& query, std::uint32_t a, std::uint32_t b) {
    return exact_verdict((*query.sides[0].tree)[a].volume, (*query.sides[1].tree)[b].volume,
                         query.b_to_a, query.tolerance)
               .contact == Contact::overlapping;
}

/// Whether the child of a node of `side` overlaps what stands against it: the other node of the
/// test or, where that was divided too, one of its children.
bool overlaps_other(const EngineQuery& query, std::uint32_t side, std::uint32_t child,
                    std::uint32_t other, bool divided) {
    const std::vector<std::uint32_t> others =
        divided ? children_of(*query.sides[1 - side].shape, other) : std::vector{other};
    return std::any_of(others.begin(), others.end(), [&](std::uint32_t node) {
        return side == 0 ? overlap(query, child, node) : overlap(query, node, child);
    });
}

}  // namespace

DivisionCounts check_divisions(const EngineQuery& query, std::span<const JudgedTest> tests) {
    std::vector<Division> divisions(tests.size());
    for (const JudgedTest& test : tests) {
        if (test.parent == no_index || test.repeated) continue;
        const IndexPair above = tests[test.parent].nodes;
        Division& division = divisions[test.parent];
        if (test.nodes.a != above.a) division.of_a.insert(test.nodes.a);
        if (test.nodes.b != above.b) division.of_b.insert(test.nodes.b);
        division.pairs += test.nodes.a != above.a && test.nodes.b != above.b;
    }
    DivisionCounts counts;
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const Division& division = divisions[i];
        const bool both = !division.of_a.empty() && !division.of_b.empty();
        // Some pairs with both children, and some with one: each its own way.
        if ((division.of_a.empty() && division.of_b.empty()) || (both && division.pairs == 0))
            continue;
        ++counts.divided;
        for (const std::uint32_t side : {0u, 1u}) {
            const std::set<std::uint32_t>& tested = side == 0 ? division.of_a : division.of_b;
            if (tested.empty()) continue;
            const TreeShape& shape = *query.sides[side].shape;
            const std::vector<std::uint32_t> children =
                children_of(shape, side == 0 ? tests[i].nodes.a : tests[i].nodes.b);
            const std::uint32_t other = side == 0 ? tests[i].nodes.b : tests[i].nodes.a;
            std::uint32_t place = 0;
            while (place < children.size() &&
                   (tested.contains(children[place]) ||
                    !overlaps_other(query, side, children[place], other, both)))
                ++place;
            if (place == children.size()) continue;
            if (counts.lacking == 0)
                counts.first = {i, side, (*query.sides[side].tree)[children[place]].number, place};
            counts.alike = counts.alike && side == counts.first.side && place == counts.first.place;
            ++counts.lacking;
            break;
        }
    }
    return counts;
}

}  // namespace scb
