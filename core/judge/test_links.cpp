#include "core/judge/test_links.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace scb {
IndexPair nodes_of(const EngineQuery& query, const EngineEvent& event) {
    return {query.sides[0].tree->index_of(event.a), query.sides[1].tree->index_of(event.b)};
}

TestLinks::Link TestLinks::take_volumes(IndexPair nodes, bool overlap, std::uint32_t parent) {
    const std::uint32_t index = taken_++;
    Link link;
    if (nodes.a != no_index && nodes.b != no_index) {
        link.led_by = parent != no_index ? parent : led_to(nodes);
        const auto [known, added] = tests_.try_emplace(pair_key(query_, nodes.a, nodes.b), index);
        link.repeated = !added;
        if (added && has_against_) against_[nodes.a].push_back(nodes.b);
        known->second = index;
    }
    if (overlap) {
        last_overlap_ = index;
        last_nodes_ = nodes;
    }
    return link;
}

/// The latest test of both parents, or of one node and the parent of the other.
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
    if (last_nodes_.a == no_index || last_nodes_.b == no_index || tested_nodes_of(items))
        return false;
    const auto of_a = query_.sides[0].tree->items(last_nodes_.a),
               of_b = query_.sides[1].tree->items(last_nodes_.b);
    if (of_a.empty() || of_b.empty()) return false;
    return std::find(of_a.begin(), of_a.end(), items.a) == of_a.end() ||
           std::find(of_b.begin(), of_b.end(), items.b) == of_b.end();
}

bool TestLinks::tested_nodes_of(IndexPair items) const { return test_of_items(items).has_value(); }

std::optional<std::uint32_t> TestLinks::test_of_items(IndexPair items) const {
    if (items == last_items_ && asked_at_ == taken_) return last_answer_;
    const std::vector<std::uint32_t> of_a = query_.sides[0].shape->holders_of(items.a),
                                     of_b = query_.sides[1].shape->holders_of(items.b);
    std::optional<std::uint32_t> latest;
    const auto take = [&](IndexPair nodes) {
        const std::optional<std::uint32_t> found = test_of(nodes);
        if (found && (!latest || *found > *latest)) latest = found;
    };
    constexpr std::size_t few = 64;
    if (of_a.size() * of_b.size() <= few || query_.self) {
        for (const std::uint32_t a : of_a)
            for (const std::uint32_t b : of_b) take({a, b});
    } else {
        // For items in many leaves, go through the recorded tests, not through all pairs of leaves.
        if (!std::exchange(has_against_, true))
            for (const auto& [key, index] : tests_)
                against_[static_cast<std::uint32_t>(key >> 32)].push_back(
                    static_cast<std::uint32_t>(key));
        const std::unordered_set<std::uint32_t> has_b(of_b.begin(), of_b.end());  // lookups only
        for (const std::uint32_t a : of_a)
            if (const auto against = against_.find(a); against != against_.end())
                for (const std::uint32_t b : against->second)
                    if (has_b.contains(b)) take({a, b});
    }
    last_items_ = items;
    asked_at_ = taken_;
    last_answer_ = latest;
    return latest;
}

std::optional<std::uint32_t> TestLinks::test_of(IndexPair nodes) const {
    const auto found = tests_.find(pair_key(query_, nodes.a, nodes.b));
    if (found == tests_.end()) return std::nullopt;
    return found->second;
}

}  // namespace scb
