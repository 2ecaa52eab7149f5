#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "scb/stage.h"

namespace scb {

/// Two triangles, or two nodes, by their indices in A and in B.
struct IndexPair {
    std::uint32_t a = 0,  ///< index in A
        b = 0;            ///< index in B
    /// By `a`, then by `b`.
    friend auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

/// The parent of a step that no other step led to.
inline constexpr std::uint32_t no_step = 0xffffffff;

/// A step of a query: a test of two volumes. The steps of a query have the numbers 0, 1, 2, ... in
/// the order of the tests.
struct Step {
    /// The nodes of A and B.
    IndexPair nodes;
    std::uint16_t depth_a = 0,  ///< depth of the node of A; the root has 0
        depth_b = 0;            ///< depth of the node of B
    /// How the test ended.
    Stage stage = Stage::overlapping;
    /// Number of the earlier step whose division led to this step; no_step for roots.
    std::uint32_t parent = no_step;

    /// Whether all members are equal.
    friend bool operator==(const Step&, const Step&) = default;
};

/// A test of two triangles.
struct ItemStep {
    /// The triangles of A and B.
    IndexPair items;
    /// Number of the step, of two leaves that overlap, that led to this test; no_step if no step
    /// did, see collide_packed.
    std::uint32_t step = 0;
    /// Whether the triangles have a point in common.
    bool hit = false;
    /// In a self query: whether the triangles share a vertex, and were not tested for that reason.
    bool neighbors = false;

    /// Whether all members are equal.
    friend bool operator==(const ItemStep&, const ItemStep&) = default;
};

/// All tests of a query, in the order in which they were made.
struct Steps {
    /// Tests of volumes, by their numbers.
    std::vector<Step> volumes;
    /// Tests of triangles, ascending by `step`.
    std::vector<ItemStep> items;

    /// Whether all tests are equal.
    friend bool operator==(const Steps&, const Steps&) = default;
};

}  // namespace scb
