#pragma once

#include <cstdint>
#include <vector>

#include "scb/observer.h"

namespace scb {

/// A test of two volumes, as an observer saw it.
struct VolumeTest {
    /// The nodes of A and B.
    IndexPair nodes;
    std::uint16_t depth_a = 0,  ///< depth of the node of A; the root has 0
        depth_b = 0;            ///< depth of the node of B
    /// How the test ended.
    Stage stage = Stage::overlapping;

    /// Whether all members are equal.
    friend bool operator==(const VolumeTest&, const VolumeTest&) = default;
};

/// A test of two triangles.
struct TriangleTest {
    /// The triangles of A and B.
    IndexPair triangles;
    std::uint32_t after = 0;  ///< index of the volume test, of the two leaves, that led to it
    /// Whether they have a point in common.
    bool intersect = false;

    /// Whether all members are equal.
    friend bool operator==(const TriangleTest&, const TriangleTest&) = default;
};

/// Every test of a query, in the order in which they were made.
struct Events {
    /// Tests of volumes.
    std::vector<VolumeTest> volume_tests;
    /// Tests of triangles; `after` says where among the others each belongs.
    std::vector<TriangleTest> triangle_tests;

    /// Whether all tests are equal.
    friend bool operator==(const Events&, const Events&) = default;
};

/// An observer for `collide` that keeps all events. Throws std::length_error where a query has more
/// than 2^32 - 1 volume tests, or a node is deeper than 65,535.
struct EventRecorder {
    /// What was recorded so far; a query adds to it.
    Events events;

    /// Keeps a test of two volumes.
    void volume_test(IndexPair nodes, int depth_a, int depth_b, Stage stage);
    /// Keeps a test of two triangles.
    void triangle_test(IndexPair triangles, bool intersect);
};

}  // namespace scb
