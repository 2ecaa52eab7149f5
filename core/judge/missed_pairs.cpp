#include "core/judge/missed_pairs.h"

#include <algorithm>

#include "core/geometry/triangle_segment.h"
#include "core/judge/tree_check.h"

namespace scb {

MissedPairs::MissedPairs(const EngineQuery& query, std::span<const JudgedTest> tests,
                         const std::unordered_map<std::uint64_t, ItemTest>& item_tests)
    : query_(query), tests_(tests), item_tests_(item_tests) {
    for (std::size_t side = 0; side < 2; ++side) {
        tests_of_[side].resize(query.sides[side].tree->size());
        mark_[side].assign(query.sides[side].tree->size(), 0);
    }
    for (std::uint32_t i = 0; i < tests.size(); ++i) {
        const IndexPair nodes = tests[i].nodes;
        if (nodes.a == no_index || nodes.b == no_index) continue;
        tests_of_[0][nodes.a].push_back(i);
        tests_of_[1][nodes.b].push_back(i);
    }
}

std::optional<Vec3> MissedPairs::contact_of(IndexPair items) const {
    const auto& [a, b] = query_.sides;
    if (!a.mesh || !b.mesh) return std::nullopt;
    const auto shared = triangles_intersection(
        corners(*a.mesh, items.a), transform_corners(query_.b_to_a, corners(*b.mesh, items.b)));
    if (!shared) return std::nullopt;
    return shared->a + (shared->b - shared->a) / 2;
}

MissedPairs::Way MissedPairs::way_to(std::size_t side, std::uint32_t item,
                                     const std::optional<Vec3>& contact) const {
    const EngineSide& of = query_.sides[side];
    Way way;
    double least = HUGE_VAL;
    const std::vector<std::uint32_t> holders = of.shape->holders_of(item);
    for (const std::uint32_t holder : holders) {
        if (holders.size() == 1 || !contact) {
            way.leaf = holder;
            break;
        }
        const NodeVolume& volume = (*of.tree)[holder].volume;
        const double away = has_volume(volume) ? excess(volume, *contact) : HUGE_VAL;
        if (way.leaf != no_index && !(away < least)) continue;
        way.leaf = holder;
        least = away;
    }
    for (std::uint32_t node = way.leaf; node != no_index; node = of.shape->parents[node])
        way.nodes.push_back(node);
    std::reverse(way.nodes.begin(), way.nodes.end());
    return way;
}

MissedPairs::Found MissedPairs::search(const Ways& ways) const {
    ++searches_;
    std::array<std::size_t, 2> work{};
    for (std::size_t side = 0; side < 2; ++side)
        for (const std::uint32_t node : ways[side].nodes) {
            mark_[side][node] = searches_;
            work[side] += tests_of_[side][node].size();
        }
    // Go through the side with fewer tests.
    const std::size_t by = work[0] <= work[1] ? 0 : 1;
    Found found;
    for (const std::uint32_t node : ways[by].nodes)
        for (const std::uint32_t i : tests_of_[by][node]) {
            const JudgedTest& test = tests_[i];
            const std::uint32_t other = by == 0 ? test.nodes.b : test.nodes.a;
            if (mark_[1 - by][other] != searches_) continue;
            if (query_.events[test.event].stage != 0 || test.left_out) {
                found.rejected = std::min(found.rejected, i);
                continue;
            }
            const std::uint32_t depth = query_.sides[0].shape->depths[test.nodes.a] +
                                        query_.sides[1].shape->depths[test.nodes.b];
            if (found.deepest != no_index && depth < found.depth) continue;
            // Of equally deep tests, take the first.
            if (found.deepest == no_index || depth > found.depth || i < found.deepest)
                found.deepest = i;
            found.depth = depth;
        }
    return found;
}

double MissedPairs::outside(std::size_t side, std::uint32_t node, std::uint32_t item) const {
    const auto [known, added] = outside_[side].try_emplace(std::uint64_t{node} << 32 | item, 0.0);
    if (added) known->second = computed_outside(side, node, item);
    return known->second;
}

double MissedPairs::computed_outside(std::size_t side, std::uint32_t node,
                                     std::uint32_t item) const {
    const EngineSide& of = query_.sides[side];
    const NodeVolume& volume = (*of.tree)[node].volume;
    // If a triangle is split between leaves, a node need contain only a part of it.
    if (!has_volume(volume) || of.shape->holders_of(item).size() > 1) return 0;
    // The other body does not matter here, so its reach counts as 0.
    const double reach = (*of.tree)[node].reach;
    const double tolerance = tolerance_at(query_, side == 0 ? reach : 0, side == 0 ? 0 : reach);
    if (!of.mesh) {
        const NodeVolume* object = of.tree->object_volume(item);
        if (!object) return 0;
        const double amount = reach_beyond(convex_shape(volume), convex_shape(*object));
        return amount > tolerance ? amount : 0;
    }
    double most = 0;
    for (const Vec3& corner : corners(*of.mesh, item)) {
        const double amount = excess(volume, corner);
        if (amount > tolerance) most = std::max(most, amount);
    }
    return most;
}

MissedPairs::Ways MissedPairs::ways_to(IndexPair items) const {
    const std::optional<Vec3> of_a = contact_of(items);
    std::optional<Vec3> of_b;
    if (of_a) of_b = transform_point(relative_pose(query_.b_to_a, Pose{}), *of_a);
    return {way_to(0, items.a, of_a), way_to(1, items.b, of_b)};
}

PairProblem MissedPairs::cause_of(IndexPair items) const {
    PairProblem problem{items};
    const std::array<std::uint32_t, 2> item{items.a, items.b};
    for (std::uint32_t side = 0; side < 2; ++side) {
        problem.side = side;
        if (query_.sides[side].tree->size() == 0) {
            problem.cause = PairCause::no_tree;
            return problem;
        }
        if (query_.sides[side].shape->holder_of(item[side]) == no_index) {
            problem.cause = PairCause::in_no_leaf;
            return problem;
        }
    }
    problem.side = 0;
    Ways ways = ways_to(items);
    if (const auto tested = item_tests_.find(pair_key(query_, items.a, items.b));
        tested != item_tests_.end()) {
        problem.event = tested->second.event;
        problem.test = tested->second.test;
        const bool meet = query_.events[problem.event].kind == EngineEvent::Kind::items_meet;
        problem.cause = meet ? PairCause::not_reported : PairCause::items_apart;
        problem.nodes = {number(0, ways[0].leaf), number(1, ways[1].leaf)};
        return problem;
    }
    Found found = search(ways);
    // A self query may test the pair in the other order.
    if (query_.self) {
        const Ways turned = ways_to({items.b, items.a});
        const Found other = search(turned);
        if (other.is_more_specific_than(found)) {
            found = other;
            ways = turned;
            problem.items = {items.b, items.a};
        }
    }
    if (found.rejected != no_index) return rejected_at(problem, found.rejected);
    if (found.deepest == no_index) return untested(problem, ways);
    const JudgedTest& test = tests_[found.deepest];
    problem.event = test.event;
    problem.test = found.deepest;
    problem.nodes = {number(0, test.nodes.a), number(1, test.nodes.b)};
    const bool leaf_pair = test.nodes.a == ways[0].leaf && test.nodes.b == ways[1].leaf;
    problem.cause = leaf_pair ? PairCause::items_not_tested : PairCause::never_visited;
    problem.next = {next_number(0, test.nodes.a, ways[0]), next_number(1, test.nodes.b, ways[1])};
    // The test that rejected a node need not be recorded: a faulty node may be the cause.
    return problem.cause == PairCause::never_visited ? below_faulty(problem, ways) : problem;
}

/// The problem if no test of nodes above the pair was recorded.
PairProblem MissedPairs::untested(PairProblem problem, const Ways& ways) const {
    problem.cause = tests_.empty() ? PairCause::no_tests : PairCause::never_tested;
    return below_faulty(problem, ways);
}

/// If no test is known, a node on a way explains the miss if it does not contain its item, or has
/// an invalid volume. Returns the problem with that node, or the problem unchanged.
PairProblem MissedPairs::below_faulty(PairProblem problem, const Ways& ways) const {
    for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t item = side == 0 ? problem.items.a : problem.items.b;
        // From the leaf up: the node nearest to the triangle.
        for (auto node = ways[side].nodes.rbegin(); node != ways[side].nodes.rend(); ++node) {
            const double amount = outside(side, *node, item);
            const bool broken = !query_.sides[side].tree->volume_fault(*node).empty();
            if (amount == 0 && !broken) continue;
            PairProblem found{problem.items};
            found.cause = broken ? PairCause::below_bad_volume : PairCause::below_outside;
            found.side = side;
            found.amount = amount;
            (side == 0 ? found.nodes.a : found.nodes.b) = number(side, *node);
            return found;
        }
    }
    return problem;
}

PairProblem MissedPairs::rejected_at(PairProblem problem, std::uint32_t at) const {
    const JudgedTest& test = tests_[at];
    problem.event = test.event;
    problem.test = at;
    problem.nodes = {number(0, test.nodes.a), number(1, test.nodes.b)};
    problem.cause =
        test.verdict == TestVerdict::wrong ? PairCause::rejected : PairCause::rejected_unproven;
    for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t node = side == 0 ? test.nodes.a : test.nodes.b,
                            item = side == 0 ? problem.items.a : problem.items.b;
        if (!query_.sides[side].tree->volume_fault(node).empty()) {
            problem.cause = PairCause::bad_volume;
            problem.side = side;
            return problem;
        }
        const double amount = outside(side, node, item);
        if (!(amount > problem.amount)) continue;
        problem.cause = PairCause::not_contained;
        problem.side = side;
        problem.amount = amount;
        problem.deepest = deepest_outside(side, node, item);
    }
    return problem;
}

/// The number of the deepest node below `node` that does not contain the item; no_index: none.
std::uint32_t MissedPairs::deepest_outside(std::size_t side, std::uint32_t node,
                                           std::uint32_t item) const {
    const TreeShape& shape = *query_.sides[side].shape;
    for (std::uint32_t below = shape.holder_of(item); below != no_index && below != node;
         below = shape.parents[below])
        if (outside(side, below, item) > 0) return number(side, below);
    return no_index;
}

/// The number of the child of `node` on the way; no_index if `node` is the leaf.
std::uint32_t MissedPairs::next_number(std::size_t side, std::uint32_t node, const Way& way) const {
    const auto at = std::find(way.nodes.begin(), way.nodes.end(), node);
    return at == way.nodes.end() || at + 1 == way.nodes.end() ? no_index : number(side, *(at + 1));
}

}  // namespace scb
