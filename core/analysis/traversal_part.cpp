#include "core/analysis/traversal_part.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace scb {

QueryTrace with_tests(const TraceHeader& header, const QueryTrace& frame,
                      const std::vector<std::uint32_t>& chosen) {
    QueryTrace result{frame.frame, frame.b_to_a, {}, {}};
    result.trees = frame.trees;
    const std::vector<ItemStep>& triangle_tests = frame.steps.items;
    Collision& found = result.found;
    const bool pairs_of_nodes = pairs_are_nodes(header);
    std::vector<std::uint32_t> place(frame.steps.volumes.size(), no_step);  // in the result
    std::size_t next = 0;
    for (const std::uint32_t i : chosen) {
        Step test = frame.steps.volumes[i];
        if (const auto stage = static_cast<std::size_t>(test.stage); stage < stage_count)
            ++found.stages[stage];
        found.depth = std::max(found.depth, test.depth_a + test.depth_b);
        if (pairs_of_nodes && test.stage == Stage::overlapping &&
            std::binary_search(frame.found.pairs.begin(), frame.found.pairs.end(), test.nodes))
            found.pairs.push_back(test.nodes);
        while (next < triangle_tests.size() && triangle_tests[next].step < i) ++next;
        for (; next < triangle_tests.size() && triangle_tests[next].step == i; ++next) {
            ItemStep of_leaves = triangle_tests[next];
            of_leaves.step = static_cast<std::uint32_t>(result.steps.volumes.size());
            result.steps.items.push_back(of_leaves);
            found.n_p += of_leaves.neighbors ? 0 : 1;
            if (of_leaves.hit) found.pairs.push_back(pair_of(header, of_leaves));
        }
        place[i] = static_cast<std::uint32_t>(result.steps.volumes.size());
        if (test.parent != no_step) test.parent = place[test.parent];
        result.steps.volumes.push_back(test);
    }
    found.n_v = chosen.size();
    if (!header.engine)
        found.n_u = transform_count(header.volume, found.stages, header.options.overlap);
    found.complete = frame.found.complete;
    std::sort(found.pairs.begin(), found.pairs.end());
    found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
    return result;
}

std::optional<std::uint32_t> test_of(const Steps& steps, IndexPair nodes) {
    for (std::uint32_t i = 0; i < steps.volumes.size(); ++i)
        if (steps.volumes[i].nodes == nodes) return i;
    return std::nullopt;
}

QueryTrace traversal_part(const TraceHeader& header, const QueryTrace& frame, std::uint32_t root) {
    const std::vector<Step>& tests = frame.steps.volumes;
    std::vector<char> below(tests.size());
    std::vector<std::uint32_t> chosen;
    // Parents come before their children.
    for (std::uint32_t i = root; i < tests.size(); ++i) {
        const std::uint32_t parent = tests[i].parent;
        below[i] = i == root || (parent != no_step && below[parent]);
        if (below[i]) chosen.push_back(i);
    }
    return with_tests(header, frame, chosen);
}

std::vector<std::uint32_t> largest_parts(const Steps& steps, std::size_t most) {
    const std::vector<std::uint32_t> sizes = subtree_sizes(steps);
    std::vector<std::uint32_t> parts;
    if (sizes.empty()) return parts;
    const auto small = [&](std::uint32_t i) { return 4 * std::uint64_t{sizes[i]} <= sizes.size(); };
    // A query of another engine may have several roots.
    for (std::uint32_t i = 0; i < sizes.size(); ++i) {
        const std::uint32_t parent = steps.volumes[i].parent;
        if (small(i) && (parent == no_step || !small(parent))) parts.push_back(i);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [&](std::uint32_t x, std::uint32_t y) { return sizes[x] > sizes[y]; });
    parts.resize(std::min(parts.size(), most));
    return parts;
}

std::vector<std::uint32_t> subtree_sizes(const Steps& steps) {
    const std::vector<Step>& tests = steps.volumes;
    std::vector<std::uint32_t> sizes(tests.size(), 1);
    // Parents come before their children.
    for (std::size_t i = sizes.size(); i-- > 0;)
        if (tests[i].parent != no_step) sizes[tests[i].parent] += sizes[i];
    return sizes;
}

std::vector<std::uint32_t> costly_tests(const Steps& steps, std::span<const std::uint32_t> first,
                                        std::size_t most) {
    const std::vector<std::uint32_t> sizes = subtree_sizes(steps);
    std::vector<std::uint32_t> others(sizes.size());
    std::iota(others.begin(), others.end(), 0);
    std::partial_sort(others.begin(),
                      others.begin() + static_cast<std::ptrdiff_t>(std::min(most, others.size())),
                      others.end(), [&sizes](std::uint32_t x, std::uint32_t y) {
                          return sizes[x] != sizes[y] ? sizes[x] > sizes[y] : x < y;
                      });
    std::set<std::uint32_t> chosen;
    for (const std::span<const std::uint32_t> tests : {first, std::span(std::as_const(others))})
        for (const std::uint32_t test : tests)
            if (chosen.size() < most) chosen.insert(test);
    return {chosen.begin(), chosen.end()};
}

}  // namespace scb
