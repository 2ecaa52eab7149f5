#include "core/judge/division_check.h"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace scb {
namespace {

/// The children of A's node and of B's node that were tested because of one test.
struct Division {
    std::set<std::uint32_t> of_a, of_b;
    std::size_t pairs = 0;  ///< tests of a child of A's node with a child of B's node
};

/// A node and the box about its volume, in A's frame.
struct BoxedNode {
    std::uint32_t node = 0;
    Box box;
};

class DivisionCheck {
  public:
    DivisionCheck(const EngineQuery& query, std::span<const JudgedTest> tests, double reach)
        : query_(query), tests_(tests), reach_(reach) {}

    DivisionCounts counted() {
        std::vector<Division> divisions(tests_.size());
        const std::vector<std::uint32_t> first = first_of_repeated();
        for (const JudgedTest& test : tests_) {
            if (test.parent == no_index) continue;
            const std::uint32_t parent = first.empty() ? test.parent : first[test.parent];
            add(divisions[parent], test.nodes, tests_[parent].nodes);
        }
        for (std::uint32_t i = 0; i < tests_.size(); ++i) check(divisions[i], i);
        return counts_;
    }

  private:
    /// Per test, the index of the first test of the same two nodes. Repeated tests count as one,
    /// since only together they may lead to all children. Empty if no test is repeated.
    std::vector<std::uint32_t> first_of_repeated() const {
        std::vector<std::uint32_t> result;
        if (std::none_of(tests_.begin(), tests_.end(),
                         [](const JudgedTest& test) { return test.repeated; }))
            return result;
        std::unordered_map<std::uint64_t, std::uint32_t> first;  // lookups only
        for (std::uint32_t i = 0; i < tests_.size(); ++i)
            result.push_back(
                first.try_emplace(pair_key(query_, tests_[i].nodes.a, tests_[i].nodes.b), i)
                    .first->second);
        return result;
    }

    const TreeShape& shape(std::uint32_t side) const { return *query_.sides[side].shape; }

    bool is_below(std::uint32_t side, std::uint32_t node, std::uint32_t above) const {
        return node == above || shape(side).parents[node] == above;
    }

    void add(Division& division, IndexPair nodes, IndexPair above) const {
        // A self query may name the two nodes in the other order.
        if (query_.self && !(is_below(0, nodes.a, above.a) && is_below(1, nodes.b, above.b)))
            std::swap(nodes.a, nodes.b);
        if (nodes.a != above.a) division.of_a.insert(nodes.a);
        if (nodes.b != above.b) division.of_b.insert(nodes.b);
        division.pairs += nodes.a != above.a && nodes.b != above.b;
    }

    std::vector<std::uint32_t> children_of(std::uint32_t side, std::uint32_t node) const {
        std::vector<std::uint32_t> children;
        for (std::uint32_t child = shape(side).first_child[node]; child != no_index;
             child = shape(side).next_sibling[child])
            children.push_back(child);
        return children;
    }

    BoxedNode boxed(std::uint32_t side, std::uint32_t node) const {
        const NodeVolume& volume = (*query_.sides[side].tree)[node].volume;
        BoxedNode result{node, {}};
        if (!has_volume(volume)) return result;
        result.box = box_about(placed(convex_shape(volume), side == 0 ? Pose{} : query_.b_to_a));
        return result;
    }

    /// Compares the boxes first, since a node may have many children.
    bool overlap(const BoxedNode& a, const BoxedNode& b) const {
        if ((a.box.lower.array() - reach_ > b.box.upper.array()).any() ||
            (b.box.lower.array() - reach_ > a.box.upper.array()).any())
            return false;
        return exact_verdict((*query_.sides[0].tree)[a.node].volume,
                             (*query_.sides[1].tree)[b.node].volume, query_.b_to_a,
                             tolerance_of(query_, {a.node, b.node}), reach_)
                   .contact == Contact::overlapping;
    }

    /// The index in `children` of the first child that was not tested although it overlaps one of
    /// `others`.
    std::optional<std::uint32_t> lack(std::uint32_t side, const std::set<std::uint32_t>& tested,
                                      const std::vector<std::uint32_t>& children,
                                      const std::vector<std::uint32_t>& others,
                                      bool against_itself) const {
        std::vector<BoxedNode> boxes;
        for (std::uint32_t place = 0; place < children.size(); ++place) {
            if (tested.contains(children[place])) continue;
            if (boxes.empty())
                for (const std::uint32_t node : others) boxes.push_back(boxed(1 - side, node));
            const BoxedNode child = boxed(side, children[place]);
            const auto meets = [&](const BoxedNode& other) {
                // A leaf needs no test with itself.
                if (against_itself && other.node == child.node)
                    return !shape(side).is_leaf(child.node);
                return side == 0 ? overlap(child, other) : overlap(other, child);
            };
            if (std::any_of(boxes.begin(), boxes.end(), meets)) return place;
        }
        return std::nullopt;
    }

    void check(const Division& division, std::uint32_t i) {
        const bool both = !division.of_a.empty() && !division.of_b.empty();
        // No child was tested, or children of both nodes but no two of them with each other.
        if ((division.of_a.empty() && division.of_b.empty()) || (both && division.pairs == 0))
            return;
        ++counts_.divided;
        const IndexPair nodes = tests_[i].nodes;
        const bool against_itself = query_.self && nodes.a == nodes.b;
        std::set<std::uint32_t> all;
        if (against_itself) {
            all = division.of_a;
            all.insert(division.of_b.begin(), division.of_b.end());
        }
        for (const std::uint32_t side : {0u, 1u}) {
            const std::set<std::uint32_t>& tested = against_itself ? all
                                                    : side == 0    ? division.of_a
                                                                   : division.of_b;
            if (tested.empty()) continue;
            const std::uint32_t node = side == 0 ? nodes.a : nodes.b,
                                other = side == 0 ? nodes.b : nodes.a;
            const std::vector<std::uint32_t> children = children_of(side, node),
                                             others = both ? children_of(1 - side, other)
                                                           : std::vector{other};
            const auto place = lack(side, tested, children, others, against_itself);
            if (!place) continue;
            if (counts_.lacking == 0)
                counts_.first = {i, side, (*query_.sides[side].tree)[children[*place]].number,
                                 *place};
            counts_.alike =
                counts_.alike && side == counts_.first.side && *place == counts_.first.place;
            ++counts_.lacking;
            return;
        }
    }

    const EngineQuery& query_;
    std::span<const JudgedTest> tests_;
    const double reach_;
    DivisionCounts counts_;
};

}  // namespace

DivisionCounts check_divisions(const EngineQuery& query, std::span<const JudgedTest> tests,
                               double reach) {
    return DivisionCheck(query, tests, reach).counted();
}

}  // namespace scb
