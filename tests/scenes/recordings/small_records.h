#pragma once

#include <vector>

#include "scenes/recordings/record.h"

namespace scb::scenes {

inline RecordedVolume ball_volume(double radius, double x = 0) {
    return {RecordedKind::ball, {x, 0, 0, radius}};
}

inline RecordedPose pose_at(std::uint32_t body, double x) {
    return {body, {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0}};
}

/// Tree and body of this number: one node, number 0, with one object, number 0.
inline std::vector<Record> body_of_one_node(std::uint32_t number, const RecordedVolume& volume) {
    return {RecordedTree{number, record_none, "", {}},
            RecordedNode{number, 0, record_none, 0, "", {}, {0}, volume},
            RecordedBody{number, number, number == 0 ? "A" : "B"}};
}

inline void append(std::vector<Record>& records, const std::vector<Record>& more) {
    records.insert(records.end(), more.begin(), more.end());
}

/// Two balls of radius 1. The ball of B moves.
inline std::vector<Record> two_balls() {
    std::vector<Record> records = body_of_one_node(0, ball_volume(1));
    append(records, body_of_one_node(1, ball_volume(1)));
    return records;
}

/// A query of A and B whose tests are these.
inline std::vector<Record> query_with(const std::vector<RecordedEvent>& events,
                                      bool complete = true) {
    std::vector<Record> records = {RecordedQuery{0, 1}};
    for (const RecordedEvent& event : events) records.emplace_back(event);
    records.emplace_back(RecordedQueryEnd{complete, 0});
    return records;
}

}  // namespace scb::scenes
