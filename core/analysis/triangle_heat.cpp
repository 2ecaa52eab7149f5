#include "core/analysis/triangle_heat.h"

#include <cassert>

namespace scb {

std::vector<bool> wasted_tests(const Steps& steps, const Outcomes& outcomes) {
    const auto is_true = [](Stage outcome) {
        return outcome == Stage::triangles_meet || outcome == Stage::found;
    };
    std::vector<bool> meets(outcomes.size()), wasted(outcomes.size());
    // A self query must reach neighbors, as it must reach triangles that meet.
    for (const ItemStep& test : steps.items)
        if ((test.hit || test.neighbors) && test.step != no_step) meets[test.step] = true;
    // Parents come before their children.
    for (std::size_t i = meets.size(); i-- > 0;) {
        if (is_true(outcomes[i])) meets[i] = true;
        if (const std::uint32_t parent = steps.volumes[i].parent; meets[i] && parent != no_step)
            meets[parent] = true;
    }
    for (std::size_t i = 0; i < meets.size(); ++i) {
        const std::uint32_t parent = steps.volumes[i].parent;
        wasted[i] = parent != no_step && !meets[parent];
    }
    return wasted;
}

std::vector<bool> wasted_tests(const Attribution& verdicts) {
    std::vector<bool> wasted;
    for (const PassReason reason : verdicts.wasted_by)
        wasted.push_back(reason != PassReason::triangles_meet);
    return wasted;
}

std::vector<std::uint32_t> triangle_heat(const Steps& steps, const TreeShape& shape,
                                         std::size_t side, HeatOf of,
                                         const std::vector<bool>& wasted) {
    assert((of != HeatOf::wasted || wasted.size() == steps.volumes.size()) &&
           "which tests are wasted is known");
    std::vector<std::uint32_t> heat(shape.holder.size());
    const auto index_on_side = [side](const IndexPair& pair) {
        return side == 0 ? pair.a : pair.b;
    };
    if (of == HeatOf::triangles) {
        for (const ItemStep& test : steps.items)
            if (!test.neighbors) ++heat[index_on_side(test.items)];
        return heat;
    }
    std::vector<std::uint32_t> tests(shape.size());
    for (std::size_t i = 0; i < steps.volumes.size(); ++i)
        if (of != HeatOf::wasted || wasted[i]) ++tests[index_on_side(steps.volumes[i].nodes)];
    // A test of a node counts for all nodes below it.
    for (const std::uint32_t i : shape.order)
        if (shape.parents[i] != no_index) tests[i] += tests[shape.parents[i]];
    for (std::size_t item = 0; item < heat.size(); ++item)
        if (shape.holder[item] != no_index) heat[item] = tests[shape.holder[item]];
    return heat;
}

}  // namespace scb
