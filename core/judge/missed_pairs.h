#pragma once

#include <array>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/judge/query_check.h"

namespace scb {

/// A test of two items, and the judged test of volumes that led to it; no_index: none.
struct ItemTest {
    std::uint32_t event = 0;  ///< index into EngineQuery::events
    std::uint32_t test = no_index;
};

/// Finds out why pairs that intersect were not reported.
class MissedPairs {
  public:
    /// `item_tests`: the first test of each pair, by pair_key. All arguments must outlive this
    /// object.
    MissedPairs(const EngineQuery& query, std::span<const JudgedTest> tests,
                const std::unordered_map<std::uint64_t, ItemTest>& item_tests);

    /// Takes O(depth + tests of the nodes above the pair). In a self query the items of the result
    /// may be swapped, as the query tested them.
    PairProblem cause_of(IndexPair items) const;

  private:
    /// The nodes of one side from the root to a leaf that holds the item, nearest to the contact.
    struct Way {
        std::uint32_t leaf = no_index;
        std::vector<std::uint32_t> nodes;
    };
    using Ways = std::array<Way, 2>;
    /// Among the tests of a node of each way: the first that rejected, and the deepest that passed.
    struct Found {
        std::uint32_t rejected = no_index, deepest = no_index;
        std::uint32_t depth = 0;  ///< sum of both nodes' depths in `deepest`

        /// A rejection is a cause. Of two tests that passed, the deeper one is nearer to the cause.
        bool is_more_specific_than(const Found& other) const {
            if (rejected != other.rejected) return rejected < other.rejected;
            if (deepest == no_index || other.deepest == no_index) return deepest < other.deepest;
            return depth > other.depth;
        }
    };

    std::optional<Vec3> contact_of(IndexPair items) const;
    Way way_to(std::size_t side, std::uint32_t item, const std::optional<Vec3>& contact) const;
    Ways ways_to(IndexPair items) const;
    Found search(const Ways& ways) const;
    PairProblem untested(PairProblem problem, const Ways& ways) const;
    PairProblem below_faulty(PairProblem problem, const Ways& ways) const;
    PairProblem rejected_at(PairProblem problem, std::uint32_t at) const;
    std::uint32_t next_number(std::size_t side, std::uint32_t node, const Way& way) const;
    /// How far the item is outside of the node's volume; 0 if within the tolerance.
    double outside(std::size_t side, std::uint32_t node, std::uint32_t item) const;
    double computed_outside(std::size_t side, std::uint32_t node, std::uint32_t item) const;
    std::uint32_t deepest_outside(std::size_t side, std::uint32_t node, std::uint32_t item) const;
    std::uint32_t number(std::size_t side, std::uint32_t node) const {
        return (*query_.sides[side].tree)[node].number;
    }

    const EngineQuery& query_;
    std::span<const JudgedTest> tests_;
    const std::unordered_map<std::uint64_t, ItemTest>& item_tests_;
    std::array<std::vector<std::vector<std::uint32_t>>, 2> tests_of_;  ///< tests, per side and node
    mutable std::array<std::vector<std::uint32_t>, 2> mark_;  ///< per node: the latest search
    mutable std::uint32_t searches_ = 0;
    /// Results of `outside`, by node and item: lookups only.
    mutable std::array<std::unordered_map<std::uint64_t, double>, 2> outside_;
};

}  // namespace scb
