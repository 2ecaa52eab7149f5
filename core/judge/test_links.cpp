#include "core/judge/test_links.h"

#include <algorithm>

namespace scb {
namespace {

std::uint64_t key_of(IndexPair nodes) { return std::uint64_t{nodes.a} << 32 | nodes.b; }

}  // namespace

IndexPair nodes_of(const EngineQuery& query, const EngineEvent& event) {
    return {query.sides[0].tree->index_of(event.a), query.sides[1].tree->index_of(event.b)};
}

TestLinks::Link TestLinks::take_volumes(IndexPair nodes, bool overlap) {
    const std::uint32_t index = taken_++;
    Link link;
    if (nodes.a != no_index && nodes.b != no_index) {
        link.led_by = led_to(nodes);
        const auto [known, added] = tests_.try_emplace(key_of(nodes), index);
        link.repeated = !added;
        known->second = index;
    }
    if (overlap) {
        last_overlap_ = index;
        last_nodes_ = nodes;
    }
    return link;
}

/// The test of the parents, or of one node and the parent of the other: the latest.
std::uint32_t TestLinks::led_to(IndexPair nodes) const {
    const std::uint32_t above_a = query_.sides[0].shape->parents[nodes.a],
                        above_b = query_.sides[1].shape->parents[nodes.b];
    std::uint32_t latest = no_index;
    for (const IndexPair above :
         {IndexPair{above_a, nodes.b}, IndexPair{nodes.a, above_b}, IndexPair{above_a, above_b}}) {
        if (above.a == no_index || above.b == no_index) continue;
        const std::optional<std::uint32_t> found = test_of(above);
        if (found && (latest == no_index || *found > latest)) latest = *found;
    }
    return latest;
}

std::uint32_t TestLinks::led_to_items(IndexPair items) const {
    return test_of_items(items).value_or(last_overlap_);
}

bool TestLinks::strays(IndexPair items) const {
    if (last_nodes_.a == no_index || last_nodes_.b == no_index) return false;
    const auto of_a = query_.sides[0].tree->items(last_nodes_.a),
               of_b = query_.sides[1].tree->items(last_nodes_.b);
    if (of_a.empty() || of_b.empty()) return false;
    const bool in_both = std::find(of_a.begin(), of_a.end(), items.a) != of_a.end() &&
                         std::find(of_b.begin(), of_b.end(), items.b) != of_b.end();
    return !in_both && !tested_nodes_of(items);
}

bool TestLinks::tested_nodes_of(IndexPair items) const { return test_of_items(items).has_value(); }

std::optional<std::uint32_t> TestLinks::test_of_items(IndexPair items) const {
    std::optional<std::uint32_t> latest;
    const auto take = [&](IndexPair nodes) {
        const std::optional<std::uint32_t> found = test_of(nodes);
        if (found && (!latest || *found > *latest)) latest = found;
    };
    const TreeShape &shape_a = *query_.sides[0].shape, &shape_b = *query_.sides[1].shape;
    for (const std::uint32_t a : shape_a.holders_of(items.a))
        for (const std::uint32_t b : shape_b.holders_of(items.b)) take({a, b});
    // A body against itself may be entered the other way round.
    if (query_.self && !latest)
        for (const std::uint32_t a : shape_a.holders_of(items.b))
            for (const std::uint32_t b : shape_b.holders_of(items.a)) take({a, b});
    return latest;
}

std::optional<std::uint32_t> TestLinks::test_of(IndexPair nodes) const {
    const auto found = tests_.find(key_of(nodes));
    if (found == tests_.end()) return std::nullopt;
    return found->second;
}

}  // namespace scb
