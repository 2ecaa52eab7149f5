#include "core/explain/overlap_steps.h"

namespace scb {

std::optional<std::size_t> OverlapSteps::decisive() const {
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (steps[i].skipped.empty() && steps[i].separates) return i;
    return std::nullopt;
}

Stage OverlapSteps::stage() const {
    const std::optional<std::size_t> i = decisive();
    return i ? steps[*i].stage : Stage::overlapping;
}

std::size_t OverlapSteps::closest() const {
    if (const std::optional<std::size_t> i = decisive()) return *i;
    std::size_t best = 0;
    for (std::size_t i = 1; i < steps.size(); ++i)
        if (steps[i].skipped.empty() && steps[i].slack > steps[best].slack) best = i;
    return best;
}

}  // namespace scb
