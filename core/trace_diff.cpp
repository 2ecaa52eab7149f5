#include "core/trace_diff.h"

#include <algorithm>

namespace scb {
namespace {

const std::string* value_of(const std::vector<TraceField>& fields, const std::string& name) {
    for (const TraceField& field : fields)
        if (field.name == name) return &field.value;
    return nullptr;
}

std::vector<FieldDifference> asked_differently(const TraceHeader& a, const TraceHeader& b) {
    std::vector<FieldDifference> result;
    const std::vector<TraceField> fields_a = fields_of(a), fields_b = fields_of(b);
    for (const TraceField& field : fields_a) {
        const std::string* other = value_of(fields_b, field.name);
        if (other == nullptr || *other != field.value)
            result.push_back({field.name, field.value, other ? *other : "-"});
    }
    for (const TraceField& field : fields_b)
        if (value_of(fields_a, field.name) == nullptr)
            result.push_back({field.name, "-", field.value});
    return result;
}

/// Index of the volume test at which the events part; nothing where they do not.
std::optional<std::size_t> parting_test(const Events& a, const Events& b) {
    if (a == b) return std::nullopt;
    const auto& tests_a = a.volume_tests;
    const auto& tests_b = b.volume_tests;
    const auto test = std::mismatch(tests_a.begin(), tests_a.end(), tests_b.begin(), tests_b.end());
    const auto triangles = std::mismatch(a.triangle_tests.begin(), a.triangle_tests.end(),
                                         b.triangle_tests.begin(), b.triangle_tests.end());
    auto result = static_cast<std::size_t>(test.first - tests_a.begin());
    // Triangles are tested after the volumes of their leaves, and before the next ones.
    if (triangles.first != a.triangle_tests.end())
        result = std::min<std::size_t>(result, triangles.first->after);
    if (triangles.second != b.triangle_tests.end())
        result = std::min<std::size_t>(result, triangles.second->after);
    return result;
}

std::optional<TracedTest> traced(const TraceHeader& header, const TraceFrame& frame,
                                 std::size_t index) {
    if (index >= frame.events.volume_tests.size()) return std::nullopt;
    return traced_test(frame, test_tree(header, frame), index);
}

bool same_pose(const Pose& a, const Pose& b) {
    return a.rotation == b.rotation && a.translation == b.translation;
}

TraceFrames frames_of(const Trace& trace) {
    return [&trace, next = std::size_t{0}]() mutable {
        return next < trace.frames.size() ? &trace.frames[next++] : nullptr;
    };
}

}  // namespace

void TraceCounts::add(const Collision& found) {
    pairs += found.pairs.size();
    n_v += found.n_v;
    n_p += found.n_p;
    n_u += found.n_u;
    for (std::size_t s = 0; s < stage_count; ++s) stages[s] += found.stages[s];
}

TracedTest traced_test(const TraceFrame& frame, const TestTree& tree, std::size_t index) {
    const Events& events = frame.events;
    TracedTest result;
    result.test = events.volume_tests[index];
    result.outcome = tree.outcomes[index];
    const auto triangles =
        std::lower_bound(events.triangle_tests.begin(), events.triangle_tests.end(), index,
                         [](const TriangleTest& t, std::size_t i) { return t.after < i; });
    if (triangles != events.triangle_tests.end() && triangles->after == index)
        result.triangles = *triangles;
    if (const std::uint32_t parent = tree.parents[index]; parent != TestTree::no_parent) {
        result.parent = events.volume_tests[parent];
        result.parent_outcome = tree.outcomes[parent];
    }
    return result;
}

TraceDiff diff(const TraceHeader& a, const TraceFrames& frames_a, const TraceHeader& b,
               const TraceFrames& frames_b) {
    TraceDiff result;
    result.asked = asked_differently(a, b);
    result.nodes_comparable =
        a.bodies[0].mesh == b.bodies[0].mesh && a.bodies[1].mesh == b.bodies[1].mesh;
    const TraceFrame* frame_a = frames_a();
    const TraceFrame* frame_b = frames_b();
    while (frame_a || frame_b) {
        if (!frame_b || (frame_a && frame_a->frame < frame_b->frame)) {
            result.only_in_a.push_back(frame_a->frame);
            frame_a = frames_a();
            continue;
        }
        if (!frame_a || frame_b->frame < frame_a->frame) {
            result.only_in_b.push_back(frame_b->frame);
            frame_b = frames_b();
            continue;
        }
        ++result.common;
        result.sum_a.add(frame_a->found);
        result.sum_b.add(frame_b->found);
        FrameDifference difference{frame_a->frame, false, {}, {}};
        difference.poses_differ = !same_pose(frame_a->b_to_a, frame_b->b_to_a);
        difference.a.add(frame_a->found);
        difference.b.add(frame_b->found);
        std::optional<std::size_t> test;
        if (result.nodes_comparable) test = parting_test(frame_a->events, frame_b->events);
        if (test && !result.first)
            result.first = Parting{frame_a->frame, *test, traced(a, *frame_a, *test),
                                   traced(b, *frame_b, *test)};
        if (test || difference.poses_differ || difference.a != difference.b)
            result.frames.push_back(difference);
        frame_a = frames_a();
        frame_b = frames_b();
    }
    return result;
}

TraceDiff diff(const Trace& a, const Trace& b) {
    return diff(a.header, frames_of(a), b.header, frames_of(b));
}

}  // namespace scb
