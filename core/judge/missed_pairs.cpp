#include "core/judge/missed_pairs.h"

#include <algorithm>

#include "core/geometry/triangle_segment.h"
#include "core/judge/tree_check.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

}  // namespace

std::uint64_t pair_key(const EngineQuery& query, std::uint32_t a, std::uint32_t b) {
    if (query.self && a > b) std::swap(a, b);
    return static_cast<std::uint64_t>(a) << 32 | b;
}

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
                                     const Vec3* contact) const {
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

void MissedPairs::search(const Way& of_a, const Way& of_b, std::uint32_t& rejected,
                         std::uint32_t& deepest) const {
    const std::array<const Way*, 2> ways{&of_a, &of_b};
    ++searches_;
    std::array<std::size_t, 2> work{};
    for (std::size_t side = 0; side < 2; ++side)
        for (const std::uint32_t node : ways[side]->nodes) {
            mark_[side][node] = searches_;
            work[side] += tests_of_[side][node].size();
        }
    // By the side with fewer tests.
    const std::size_t by = work[0] <= work[1] ? 0 : 1;
    std::uint32_t most = 0;
    for (const std::uint32_t node : ways[by]->nodes)
        for (const std::uint32_t i : tests_of_[by][node]) {
            const JudgedTest& test = tests_[i];
            const std::uint32_t other = by == 0 ? test.nodes.b : test.nodes.a;
            if (mark_[1 - by][other] != searches_) continue;
            if (query_.events[test.event].stage != 0) {
                rejected = std::min(rejected, i);
                continue;
            }
            const std::uint32_t depth = query_.sides[0].shape->depths[test.nodes.a] +
                                        query_.sides[1].shape->depths[test.nodes.b];
            if (deepest != no_index && depth < most) continue;
            // Of equally deep ones the first.
            if (deepest == no_index || depth > most || i < deepest) deepest = i;
            most = depth;
        }
}

double MissedPairs::outside(std::size_t side, std::uint32_t node, std::uint32_t item) const {
    const EngineSide& of = query_.sides[side];
    const NodeVolume& volume = (*of.tree)[node].volume;
    if (!has_volume(volume)) return 0;
    if (!of.mesh) {
        const NodeVolume* object = of.tree->object_volume(item);
        if (!object) return 0;
        const double amount = reach_beyond(convex_shape(volume), convex_shape(*object));
        return amount > query_.tolerance ? amount : 0;
    }
    double most = 0;
    for (const Vec3& corner : corners(*of.mesh, item)) {
        const double amount = excess(volume, corner);
        if (amount > query_.tolerance) most = std::max(most, amount);
    }
    return most;
}

PairProblem MissedPairs::cause_of(IndexPair items) {
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
    const std::optional<Vec3> contact = contact_of(items);
    std::optional<Vec3> of_b = contact;
    if (contact) {
        const Pose to_b = relative_pose(query_.b_to_a, Pose{});
        of_b = transform_point(to_b, *contact);
    }
    const std::array<Way, 2> ways{way_to(0, items.a, contact ? &*contact : nullptr),
                                  way_to(1, items.b, of_b ? &*of_b : nullptr)};
    if (const auto tested = item_tests_.find(pair_key(query_, items.a, items.b));
        tested != item_tests_.end()) {
        problem.event = tested->second.event;
        problem.test = tested->second.test;
        const bool meet = query_.events[problem.event].kind == Kind::items_meet;
        problem.cause = meet ? PairCause::not_reported : PairCause::items_apart;
        problem.nodes = {number(0, ways[0].leaf), number(1, ways[1].leaf)};
        return problem;
    }
    std::uint32_t rejected = no_index, deepest = no_index;
    search(ways[0], ways[1], rejected, deepest);
    // A body against itself may be entered the other way round.
    std::uint32_t rejected_turned = no_index, deepest_turned = no_index;
    if (query_.self) search(ways[1], ways[0], rejected_turned, deepest_turned);
    if (rejected == no_index && deepest == no_index) {
        rejected = rejected_turned;
        deepest = deepest_turned;
    }
    if (rejected != no_index) return rejected_at(problem, rejected);
    if (deepest == no_index) return untested(problem, ways);
    const JudgedTest& test = tests_[deepest];
    problem.event = test.event;
    problem.test = deepest;
    problem.nodes = {number(0, test.nodes.a), number(1, test.nodes.b)};
    const bool leaf_pair = (test.nodes.a == ways[0].leaf && test.nodes.b == ways[1].leaf) ||
                           (test.nodes.a == ways[1].leaf && test.nodes.b == ways[0].leaf);
    problem.cause = leaf_pair ? PairCause::items_not_tested : PairCause::never_visited;
    problem.next = {next_number(0, test.nodes.a, ways[0]), next_number(1, test.nodes.b, ways[1])};
    // Of a test that rejected a node nothing need be recorded.
    return problem.cause == PairCause::never_visited ? below_faulty(problem, ways) : problem;
}

/// No test of the nodes above the pair was recorded.
PairProblem MissedPairs::untested(PairProblem problem, const std::array<Way, 2>& ways) const {
    problem.cause = tests_.empty() ? PairCause::no_tests : PairCause::never_tested;
    return below_faulty(problem, ways);
}

/// A node on the way that does not contain its item is enough of a cause, where no test is known:
/// the problem with that node, or as it is.
PairProblem MissedPairs::below_faulty(PairProblem problem, const std::array<Way, 2>& ways) const {
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
    problem.cause = PairCause::rejected;
    for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t node = side == 0 ? test.nodes.a : test.nodes.b,
                            item = side == 0 ? problem.items.a : problem.items.b;
        if (!query_.sides[side].tree->volume_fault(node).empty()) {
            problem.cause = PairCause::bad_volume;
            problem.side = side;
            return problem;
        }
        // Of a triangle that is split between leaves, a node contains a part.
        if (query_.sides[side].shape->holders_of(item).size() > 1) continue;
        const double amount = outside(side, node, item);
        if (!(amount > problem.amount)) continue;
        problem.cause = PairCause::not_contained;
        problem.side = side;
        problem.amount = amount;
    }
    return problem;
}

/// The number of the child of `node` on the way; no_index of the leaf itself.
std::uint32_t MissedPairs::next_number(std::size_t side, std::uint32_t node, const Way& way) const {
    const auto at = std::find(way.nodes.begin(), way.nodes.end(), node);
    return at == way.nodes.end() || at + 1 == way.nodes.end() ? no_index : number(side, *(at + 1));
}

}  // namespace scb
