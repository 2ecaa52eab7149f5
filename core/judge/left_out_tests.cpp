#include "core/judge/left_out_tests.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "core/judge/item_contact.h"
#include "core/judge/test_links.h"

namespace scb {
namespace {

/// The pairs of items that a query tested or reported, by pair_key: lookups only.
std::unordered_set<std::uint64_t> measured_items(const EngineQuery& query) {
    std::unordered_set<std::uint64_t> measured;
    for (const EngineEvent& event : query.events)
        if (event.kind != EngineEvent::Kind::volumes)
            measured.insert(pair_key(query, event.a, event.b));
    return measured;
}

/// Whether a pair of leaves without a test of their items was left out: some of their triangles
/// were not measured elsewhere. In doubt it was not.
bool misses_items(const EngineQuery& query, IndexPair leaves,
                  const std::unordered_set<std::uint64_t>& measured) {
    constexpr std::size_t most_pairs = 4096;
    const auto of_a = query.sides[0].tree->items(leaves.a),
               of_b = query.sides[1].tree->items(leaves.b);
    if (measured.empty() || query.self || !have_meshes(query) ||
        of_a.size() * of_b.size() > most_pairs)
        return false;
    for (const std::uint32_t a : of_a)
        for (const std::uint32_t b : of_b)
            if (!measured.contains(pair_key(query, a, b)) && has_items(query, {a, b}) &&
                are_finite(query, {a, b}))
                return true;
    return false;
}

}  // namespace

std::vector<bool> left_out_tests(const EngineQuery& query) {
    if (query.kind == QueryKind::collide) return {};
    // A query that ended early leaves nodes that it had no reason to leave out.
    double most = query.complete ? 0 : query.limit;
    if (!query.complete && query.kind == QueryKind::distance && query.answer)
        most = std::min(most, query.answer->distance) / (1 + query.relative_error);
    const std::unordered_set<std::uint64_t> measured = measured_items(query);
    TestLinks links(query);
    std::vector<bool> left_out;
    std::vector<std::uint32_t> first;  // per test, the first test of the same nodes
    std::unordered_map<std::uint64_t, std::uint32_t> tests;  // lookups only
    const auto keep = [&](std::uint32_t led_by) {
        if (led_by != no_index) left_out[first[led_by]] = false;
    };
    bool reports_below = false;  // pairs below nodes whose leaves were not tested
    for (const EngineEvent& event : query.events) {
        if (event.kind != EngineEvent::Kind::volumes) {
            reports_below |=
                event.kind == EngineEvent::Kind::pair && !links.tested_nodes_of({event.a, event.b});
            keep(links.led_to_items({event.a, event.b}));
            continue;
        }
        const IndexPair nodes = nodes_of(query, event);
        keep(links.take_volumes(nodes, event.stage == 0, event.parent).led_by);
        const auto number = static_cast<std::uint32_t>(left_out.size());
        const bool exists = nodes.a != no_index && nodes.b != no_index;
        first.push_back(
            exists ? tests.try_emplace(pair_key(query, nodes.a, nodes.b), number).first->second
                   : number);
        const bool leaves = exists && query.sides[0].shape->is_leaf(nodes.a) &&
                            query.sides[1].shape->is_leaf(nodes.b);
        left_out.push_back(exists && event.has_length && !(event.length < most) &&
                           (!leaves || misses_items(query, nodes, measured)));
    }
    for (std::size_t i = 0; i < left_out.size(); ++i)
        left_out[i] = !reports_below && left_out[i] && left_out[first[i]];
    return left_out;
}

}  // namespace scb
