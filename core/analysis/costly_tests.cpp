#include "core/analysis/costly_tests.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace scb {

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
