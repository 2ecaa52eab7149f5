#include "core/judge/query_overlaps.h"

#include "core/analysis/level_overlaps.h"

namespace scb {

std::vector<std::size_t> level_overlaps(const EngineQuery& query, std::size_t most) {
    if (query.self || !query.placed) return {};
    const EngineSide &a = query.sides[0], &b = query.sides[1];
    return level_overlaps(
        *a.shape, *b.shape,
        [&](std::uint32_t x, std::uint32_t y) {
            return exact_verdict((*a.tree)[x].volume, (*b.tree)[y].volume, query.b_to_a,
                                 tolerance_of(query, {x, y}))
                       .contact != Contact::disjoint;
        },
        most);
}

}  // namespace scb
