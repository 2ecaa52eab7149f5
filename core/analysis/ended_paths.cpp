#include "core/analysis/ended_paths.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace scb {
namespace {

/// `counts` has zeros, before and after.
EndedPaths summary(std::span<const Stage> endings, EndingCounts& counts) {
    EndedPaths result;
    result.tests = static_cast<std::uint32_t>(endings.size());
    result.first = endings.front();
    result.last = endings.back();
    for (const Stage ending : endings) {
        ++counts[static_cast<std::size_t>(ending)];
        result.rejected += is_rejection(ending);
    }
    for (const Stage ending : endings) {
        // Most nodes have few of the many endings.
        const auto count = std::exchange(counts[static_cast<std::size_t>(ending)], 0);
        if (count > result.of_dominant ||
            (count == result.of_dominant && ending < result.dominant)) {
            result.dominant = ending;
            result.of_dominant = static_cast<std::uint32_t>(count);
        }
    }
    return result;
}

std::uint32_t node_of(const Step& test, std::size_t side) {
    return side == 0 ? test.nodes.a : test.nodes.b;
}

std::uint16_t depth_of(const Step& test, std::size_t side) {
    return side == 0 ? test.depth_a : test.depth_b;
}

/// Which outcomes are endings that pass the filter.
std::array<bool, StageTable::most_rows> passing_endings(const EndedPathsFilter& filter) {
    std::array<bool, StageTable::most_rows> passing{};
    for (std::size_t i = 0; i < passing.size(); ++i)
        passing[i] = is_ending(static_cast<Stage>(i)) && filter.endings.empty();
    for (const Stage ending : filter.endings)
        passing[static_cast<std::size_t>(ending)] = is_ending(ending);
    return passing;
}

}  // namespace

std::vector<EndedPaths> ended_paths(const QueryTrace& frame, const Outcomes& outcomes,
                                    std::size_t side, const EndedPathsFilter& filter) {
    const std::span<const Step> tests(frame.steps.volumes.data(), outcomes.size());
    std::uint32_t nodes = 0;
    for (const Step& test : tests) nodes = std::max(nodes, node_of(test, side) + 1);
    // A query has millions of tests, so the endings are not sorted: they are counted per node, and
    // then put behind each other, node by node, each node's in the order of the traversal.
    const auto passing = passing_endings(filter);
    const auto passes = [&](std::size_t test) {
        const int depth = depth_of(tests[test], side);
        return passing[static_cast<std::size_t>(outcomes[test])] && depth >= filter.least_depth &&
               depth <= filter.most_depth;
    };
    std::vector<std::uint32_t> tested(nodes), ends(nodes);
    std::vector<std::uint16_t> depths(nodes);
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const std::uint32_t node = node_of(tests[i], side);
        if (!is_ending(outcomes[i])) {
            ++tested[node];
        } else if (passes(i)) {
            ++tested[node];
            ++ends[node];
            depths[node] = depth_of(tests[i], side);
        }
    }
    // Of each node, first the begin of its endings, then, as they are put, their end.
    std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), 0u);
    std::vector<Stage> endings(tests.size());
    for (std::size_t i = 0; i < tests.size(); ++i)
        if (passes(i)) endings[ends[node_of(tests[i], side)]++] = outcomes[i];
    std::vector<EndedPaths> front;
    EndingCounts counts{};
    for (std::uint32_t node = 0, begin = 0; node < nodes; begin = ends[node++]) {
        if (ends[node] == begin) continue;
        EndedPaths& ended = front.emplace_back(
            summary(std::span<const Stage>(endings).subspan(begin, ends[node] - begin), counts));
        ended.node = node;
        ended.depth = depths[node];
        ended.tested = tested[node];
    }
    return front;
}

std::vector<EndedPaths> innermost(const std::vector<EndedPaths>& front, const TreeShape& shape) {
    std::vector<char> holds(shape.size());  // whether the node, or a node below it, is in the front
    for (const EndedPaths& node : front) holds[node.node] = 1;
    std::vector<char> below(shape.size());
    for (auto i = shape.order.rbegin(); i != shape.order.rend(); ++i)
        if (const std::uint32_t parent = shape.parents[*i]; parent != no_index && holds[*i])
            holds[parent] = below[parent] = 1;
    std::vector<EndedPaths> result;
    for (const EndedPaths& node : front)
        if (!below[node.node]) result.push_back(node);
    return result;
}

}  // namespace scb
