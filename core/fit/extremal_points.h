#pragma once

#include <array>
#include <cstdint>

#include "core/fit/dop26.h"
#include "core/fit/few_points.h"

namespace scb {

/// Per direction of a DOP, the indices of its pair of extremal points.
struct ExtremalPairs {
    alignas(64) std::array<std::int32_t, Dop26::padded> upper, lower;
};

/// The distinct extremal points of a DOP (the set E of Figure 3), looked up by id, in the order of
/// the directions, upper before lower; and the pairs among them.
void extremal_points(const Dop26& dop, const PointsView& by_id, FewPoints& points,
                     ExtremalPairs& pairs);

}  // namespace scb
