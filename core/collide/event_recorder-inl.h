#pragma once

#include <limits>
#include <stdexcept>

#include "scb/event_recorder.h"

// Inline only in the traversal that is compiled with it.
namespace scb {

inline void EventRecorder::volume_test(IndexPair nodes, int depth_a, int depth_b, Stage stage) {
    constexpr int deepest = std::numeric_limits<std::uint16_t>::max();
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    if (depth_a > deepest || depth_b > deepest || events.volume_tests.size() == most)
        throw std::length_error("a query too deep or too long to be recorded");
    events.volume_tests.push_back(
        {nodes, static_cast<std::uint16_t>(depth_a), static_cast<std::uint16_t>(depth_b), stage});
}

inline void EventRecorder::triangle_test(IndexPair triangles, bool intersect) {
    events.triangle_tests.push_back(
        {triangles, static_cast<std::uint32_t>(events.volume_tests.size() - 1), intersect});
}

}  // namespace scb
