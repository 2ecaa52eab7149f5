#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// A query of another engine, written by hand.
struct MadeQuery {
    static constexpr std::uint32_t none = TraversalTree::no_parent;

    TraceHeader header;
    TraceFrame frame;

    MadeQuery() { header.engine.emplace(); }

    /// A test of the nodes of these numbers that `parent` led to.
    void test(std::uint32_t parent, IndexPair nodes, bool passes = true) {
        std::uint16_t depth = 0;
        for (std::uint32_t above = parent; above != none; above = frame.parents[above]) ++depth;
        frame.parents.push_back(parent);
        const Stage stage = passes ? Stage::overlapping : Stage::ball_ball;
        frame.events.volume_tests.push_back({nodes, depth, 0, stage});
        ++frame.found.stages[static_cast<std::size_t>(stage)];
        ++frame.found.n_v;
        frame.found.depth = std::max(frame.found.depth, int{depth});
    }
    /// A test of two triangles that the last of the tests led to.
    void triangles(IndexPair triangles, bool intersect) {
        const auto after = static_cast<std::uint32_t>(frame.events.volume_tests.size() - 1);
        frame.events.triangle_tests.push_back({triangles, after, intersect});
        ++frame.found.n_p;
        if (intersect) frame.found.pairs.push_back(triangles);
    }
    TraversalTree tree() const { return traversal_tree(header, frame); }
};

}  // namespace scb
