#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// The indices of the nodes that a test of volumes names; no_index: no such node.
IndexPair nodes_of(const EngineQuery& query, const EngineEvent& event);

/// Finds the test that led to each test of a query: as recorded, or else inferred from the trees
/// and the order of the tests. Tests of volumes are numbered in order.
class TestLinks {
  public:
    /// The query must outlive this object.
    explicit TestLinks(const EngineQuery& query) : query_(query) {}

    struct Link {
        std::uint32_t led_by = no_index;  ///< recorded or inferred
        bool repeated = false;            ///< the query had made the test before
    };
    /// Takes the next test of two volumes. `nodes`: indices, or no_index. `parent`: the recorded
    /// test that led to it, if any.
    Link take_volumes(IndexPair nodes, bool overlap, std::uint32_t parent = no_index);
    /// The test of volumes that led to a test of two items: the latest test of nodes that hold the
    /// items or, without one, the latest test that passed.
    std::uint32_t led_to_items(IndexPair items) const;
    /// Whether nodes that hold the items were tested.
    bool tested_nodes_of(IndexPair items) const;
    /// Whether nodes that hold the items were not tested, and the items are not in the two leaves
    /// of the latest test that passed. Engines that test triangles at leaves take them from these
    /// leaves.
    bool strays(IndexPair items) const;
    /// The latest test of these nodes.
    std::optional<std::uint32_t> test_of(IndexPair nodes) const;

  private:
    std::uint32_t led_to(IndexPair nodes) const;
    std::optional<std::uint32_t> test_of_items(IndexPair items) const;

    const EngineQuery& query_;
    std::unordered_map<std::uint64_t, std::uint32_t> tests_;  ///< by nodes: lookups only
    /// Per node of A, the nodes of B that were tested against it, in any order. Used from the first
    /// item on that is in many leaves.
    mutable std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> against_;
    mutable bool has_against_ = false;
    std::uint32_t taken_ = 0, last_overlap_ = no_index;
    IndexPair last_nodes_{no_index, no_index};  ///< nodes of last_overlap_
    // The last result of test_of_items, and the number of tests then: callers repeat the question.
    mutable IndexPair last_items_{no_index, no_index};
    mutable std::uint32_t asked_at_ = 0;
    mutable std::optional<std::uint32_t> last_answer_;
};

}  // namespace scb
