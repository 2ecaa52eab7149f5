#include "core/analysis/level_overlaps.h"

#include "core/collide/query_placement.h"
#include "core/overlap/test_functors.h"

namespace scb {

std::vector<std::size_t> level_overlaps(const AnyHierarchy& a, const TreeShape& shape_a,
                                        const AnyHierarchy& b, const TreeShape& shape_b,
                                        const Pose& b_to_a, const OverlapOptions& test,
                                        std::size_t most) {
    return std::visit(
        [&]<Volume V>(const Hierarchy<V>& of_a) {
            const auto& of_b = std::get<Hierarchy<V>>(b);
            const Placement placed = query_placement(of_a, of_b, b_to_a);
            return with_overlap_test<V>(test, [&](auto overlap) {
                return level_overlaps(
                    shape_a, shape_b,
                    [&](std::uint32_t x, std::uint32_t y) {
                        return overlap(of_a.volumes[x], of_b.volumes[y], placed) ==
                               Stage::overlapping;
                    },
                    most);
            });
        },
        a);
}

}  // namespace scb
