#pragma once

#include <cstdint>
#include <vector>

#include "scb/observer.h"

namespace scb {

/// A test of two volumes, as an observer saw it.
struct VolumeTest {
    IndexPair nodes;
    std::uint16_t depth_a = 0, depth_b = 0;
    Stage stage = Stage::overlapping;

    friend bool operator==(const VolumeTest&, const VolumeTest&) = default;
};

/// A test of two triangles.
struct TriangleTest {
    IndexPair triangles;
    std::uint32_t after = 0;  ///< index of the volume test, of the two leaves, that led to it
    bool intersect = false;

    friend bool operator==(const TriangleTest&, const TriangleTest&) = default;
};

/// Every test of a query, in the order in which they were made.
struct Events {
    std::vector<VolumeTest> volume_tests;
    std::vector<TriangleTest> triangle_tests;

    friend bool operator==(const Events&, const Events&) = default;
};

/// An observer for `collide` that keeps all events. Throws std::length_error where a query has more
/// than 2^32 - 1 volume tests, or a node is deeper than 65,535.
struct EventRecorder {
    Events events;

    void volume_test(IndexPair nodes, int depth_a, int depth_b, Stage stage);
    void triangle_test(IndexPair triangles, bool intersect);
};

}  // namespace scb
