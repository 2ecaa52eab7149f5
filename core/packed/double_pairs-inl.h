// Included once for each SIMD target, see simd_targets.h.
#if defined(SCB_CORE_DOUBLE_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SCB_CORE_DOUBLE_PAIRS_INL_H_
#undef SCB_CORE_DOUBLE_PAIRS_INL_H_
#else
#define SCB_CORE_DOUBLE_PAIRS_INL_H_
#endif

#include "core/base/double_lanes-inl.h"
#include "core/packed/packed_query.h"
#include "core/packed/triangle_kernel-inl.h"
#include "scb/triangle_overlap.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

/// Decides nearly all of the pairs that floats left undecided, by the same determinants in doubles.
/// Pairs that intersect move to `found.pairs`; pairs that only an exact test can decide stay
/// undecided, in their order.
inline void decide_in_doubles(const Mesh& a, const Mesh& b, const Pose& b_to_a,
                              PackedFindings& found) {
    std::vector<IndexPair>& undecided = found.undecided;
    std::size_t left = 0;
    for (std::size_t first = 0; first < undecided.size(); first += double_lanes) {
        const std::size_t count = std::min(double_lanes, undecided.size() - first);
        double rows[15][double_lanes] = {};
        for (std::size_t k = 0; k < count; ++k) {
            const IndexPair& pair = undecided[first + k];
            const TriangleCorners p = corners(a, pair.a),
                                  q = transform_corners(b_to_a, corners(b, pair.b));
            const Vec3* const points[] = {&p[1], &p[2], &q[0], &q[1], &q[2]};
            for (std::size_t i = 0; i < 5; ++i)
                for (int axis = 0; axis < 3; ++axis)
                    rows[3 * i + static_cast<std::size_t>(axis)][k] =
                        (*points[i])[axis] - p[0][axis];
        }
        const auto point = [&rows](std::size_t i) HWY_ATTR {
            return Doubles3{Doubles::load(rows[3 * i]), Doubles::load(rows[3 * i + 1]),
                            Doubles::load(rows[3 * i + 2])};
        };
        TrianglePairs<double_lanes, double> pairs = {point(0), point(1), point(2),
                                                     point(3), point(4), Doubles::all(0)};
        // A difference is off by 2^-53 D at most; the determinants need a larger error.
        pairs.error = magnitude(pairs) * Doubles::all(0x1p-48);
        const Certainty<double_lanes, double> certain = intersection(pairs);
        const std::uint32_t yes = certain.intersect.bits(), open = certain.open.bits() & ~yes;
        for (std::size_t k = 0; k < count; ++k) {
            const IndexPair pair = undecided[first + k];
            if ((yes >> k & 1) != 0)
                found.pairs.push_back(pair);
            else if ((open >> k & 1) != 0)
                undecided[left++] = pair;
        }
    }
    undecided.resize(left);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#endif
