#include "core/analysis/ended_paths.h"

#include <algorithm>
#include <map>
#include <span>

namespace scb {
namespace {

struct End {
    std::uint32_t node;
    std::uint16_t depth;
    Stage ending;
};

EndedPaths summary(std::span<const End> ends) {
    EndedPaths result;
    result.node = ends.front().node;
    result.depth = ends.front().depth;
    result.tests = static_cast<std::uint32_t>(ends.size());
    result.first = ends.front().ending;
    result.last = ends.back().ending;
    std::array<std::uint32_t, StageTable::most_rows> counts{};
    for (const End& end : ends) {
        ++counts[static_cast<std::size_t>(end.ending)];
        result.rejected += is_rejection(end.ending);
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    result.dominant = static_cast<Stage>(most - counts.begin());
    result.of_dominant = *most;
    return result;
}

}  // namespace

std::vector<EndedPaths> ended_paths(const QueryTrace& frame, const Outcomes& outcomes,
                                    std::size_t side, const EndedPathsFilter& filter) {
    std::vector<End> ends;
    std::map<std::uint32_t, std::uint32_t> passed_on;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Step& test = frame.steps.volumes[i];
        const Stage outcome = outcomes[i];
        if (!is_ending(outcome)) {
            ++passed_on[side == 0 ? test.nodes.a : test.nodes.b];
            continue;
        }
        const std::uint16_t depth = side == 0 ? test.depth_a : test.depth_b;
        if (depth < filter.least_depth || depth > filter.most_depth) continue;
        if (!filter.endings.empty() && std::find(filter.endings.begin(), filter.endings.end(),
                                                 outcome) == filter.endings.end())
            continue;
        ends.push_back({side == 0 ? test.nodes.a : test.nodes.b, depth, outcome});
    }
    // Stable, so that `first` and `last` follow the order of the traversal.
    std::stable_sort(ends.begin(), ends.end(),
                     [](const End& x, const End& y) { return x.node < y.node; });
    std::vector<EndedPaths> front;
    for (std::size_t begin = 0; begin < ends.size();) {
        std::size_t end = begin + 1;
        while (end < ends.size() && ends[end].node == ends[begin].node) ++end;
        front.push_back(summary(std::span(ends).subspan(begin, end - begin)));
        const auto passed = passed_on.find(ends[begin].node);
        front.back().tested = front.back().tests + (passed == passed_on.end() ? 0 : passed->second);
        begin = end;
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
