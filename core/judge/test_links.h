#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// The indices of the nodes that a test of volumes names; no_index: there is none.
IndexPair nodes_of(const EngineQuery& query, const EngineEvent& event);

/// Which test of a query led to which: as the engine recorded it, else restored from the trees and
/// the order of the tests. Tests are numbered in order.
class TestLinks {
  public:
    /// The query must outlive this.
    explicit TestLinks(const EngineQuery& query) : query_(query) {}

    struct Link {
        std::uint32_t led_by = no_index;  ///< as far as one can tell
        bool repeated = false;            ///< the query made the test before
    };
    /// Takes the next test of two volumes: of nodes by their indices, perhaps no_index.
    /// `parent`: the test that led to it, where the engine recorded it.
    Link take_volumes(IndexPair nodes, bool overlap, std::uint32_t parent = no_index);
    /// The test of volumes that led to a test of two items: the latest of the nodes that have them;
    /// where there was none, the latest that passed.
    std::uint32_t led_to_items(IndexPair items) const;
    /// Whether the nodes that have them were tested.
    bool tested_nodes_of(IndexPair items) const;
    /// Whether they were not, nor are they in the two leaves that the latest test that passed was
    /// of: engines that test triangles at leaves take them from these.
    bool strays(IndexPair items) const;
    /// The latest test of these nodes.
    std::optional<std::uint32_t> test_of(IndexPair nodes) const;

  private:
    std::uint32_t led_to(IndexPair nodes) const;
    std::optional<std::uint32_t> test_of_items(IndexPair items) const;

    const EngineQuery& query_;
    std::unordered_map<std::uint64_t, std::uint32_t> tests_;  ///< by nodes: lookups only
    /// By a node of A: the nodes of B that were tested against it, from the first item on that is
    /// in many leaves. Their order does not matter.
    mutable std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> against_;
    mutable bool has_against_ = false;
    std::uint32_t taken_ = 0, last_overlap_ = no_index;
    IndexPair last_nodes_{no_index, no_index};  ///< those of last_overlap_
    // The last answer of test_of_items, and how many tests there were: it is asked for repeatedly.
    mutable IndexPair last_items_{no_index, no_index};
    mutable std::uint32_t asked_at_ = 0;
    mutable std::optional<std::uint32_t> last_answer_;
};

}  // namespace scb
