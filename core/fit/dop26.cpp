#include "core/fit/dop26.h"

#include "core/base/simd_targets.h"

// For the baseline target alone: this is for plain lists of points, and for tests.
#include "core/fit/dop26-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

Dop26 dop_of_list(const PointsView& points, std::uint32_t first_id) {
    Dop26 dop;
    for (std::size_t i = 0; i < Dop26::padded; i += double_lanes) {
        DopLanes lanes = DopLanes::of_point(Doubles3::all(points[0]), first_id, i);
        for (std::size_t k = 1; k < points.size; ++k)
            lanes = merge(lanes, DopLanes::of_point(Doubles3::all(points[k]),
                                                    static_cast<double>(first_id + k), i));
        lanes.store(dop, i);
    }
    return dop;
}

Dop26 merged(Dop26 a, const Dop26& b) {
    merge_into(a, b);
    return a;
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

namespace scb {

Dop26 dop26_of(const PointsView& points, std::uint32_t first_id) {
    return HWY_NAMESPACE::dop_of_list(points, first_id);
}

Dop26 merge(const Dop26& a, const Dop26& b) { return HWY_NAMESPACE::merged(a, b); }

}  // namespace scb
