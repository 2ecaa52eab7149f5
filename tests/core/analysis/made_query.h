#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// The parents of all steps.
inline std::vector<std::uint32_t> parents_of(const Steps& steps) {
    std::vector<std::uint32_t> parents;
    for (const Step& step : steps.volumes) parents.push_back(step.parent);
    return parents;
}

/// Steps with these parents; nothing else of them is set.
inline Steps steps_with_parents(const std::vector<std::uint32_t>& parents) {
    Steps steps;
    for (const std::uint32_t parent : parents) steps.volumes.emplace_back().parent = parent;
    return steps;
}

/// A query of another engine, written by hand.
struct MadeQuery {
    static constexpr std::uint32_t none = no_step;

    TraceHeader header;
    QueryTrace frame;

    MadeQuery() { header.engine.emplace(); }

    /// A test of the nodes of these numbers that `parent` led to.
    void test(std::uint32_t parent, IndexPair nodes, bool passes = true) {
        std::uint16_t depth = 0;
        for (std::uint32_t above = parent; above != none; above = frame.steps.volumes[above].parent)
            ++depth;
        const Stage stage = passes ? Stage::overlapping : Stage::ball_ball;
        frame.steps.volumes.push_back({nodes, depth, 0, stage, parent});
        ++frame.found.stages[static_cast<std::size_t>(stage)];
        ++frame.found.n_v;
        frame.found.depth = std::max(frame.found.depth, int{depth});
    }
    /// A test of two triangles that the last of the tests led to.
    void triangles(IndexPair triangles, bool intersect) {
        const auto after = static_cast<std::uint32_t>(frame.steps.volumes.size() - 1);
        frame.steps.items.push_back({triangles, after, intersect});
        ++frame.found.n_p;
        if (intersect) frame.found.pairs.push_back(triangles);
    }
    Outcomes outcomes() const { return outcomes_of(header, frame); }
};

}  // namespace scb
