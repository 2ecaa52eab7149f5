#pragma once

#include <cassert>
#include <concepts>

#include "core/overlap/overlap_convex.h"
#include "core/overlap/overlap_extents.h"
#include "core/overlap/overlap_figure8.h"
#include "core/overlap/overlap_obb.h"
#include "core/overlap/overlap_scb2.h"
#include "core/overlap/overlap_symmetric.h"
#include "scb/ball.h"
#include "scb/overlap_options.h"
#include "scb/placement.h"
#include "scb/stage.h"
#include "scb/volume.h"

namespace scb {

/// Two balls: exact, up to the placement's margin.
inline Stage overlap_ball(const Ball& a, const Ball& b, const Placement& placed) {
    const Vec3 c = transform_point(placed.b_to_a, b.center) - a.center;
    const double sum = a.radius + b.radius + placed.margin;
    return squared_norm(c) > sum * sum ? Stage::ball_ball : Stage::overlapping;
}

/// An overlap test as a type, so that a traversal is compiled for it. Called with A, B and the
/// placement of B, it returns the stage that rejected them, or overlapping.
struct BallTest {
    Stage operator()(const Ball& a, const Ball& b, const Placement& placed) const {
        return overlap_ball(a, b, placed);
    }
};
struct ObbTest {
    Stage operator()(const Obb& a, const Obb& b, const Placement& placed) const {
        return overlap_obb(a, b, placed);
    }
};
template <bool exact>
struct AabbTest {
    Stage operator()(const BasicAabb<exact>& a, const BasicAabb<exact>& b,
                     const Placement& placed) const {
        return overlap_aabb(a, b, placed);
    }
};
struct Scb2Test {
    Stage operator()(const Scb2& a, const Scb2& b, const Placement& placed) const {
        return overlap_scb2(a, b, placed);
    }
};
template <ConvexVolume V>
struct ConvexTest {
    Stage operator()(const V& a, const V& b, const Placement& placed) const {
        return overlap_convex(a, b, placed);
    }
};
template <OverlapTest test>
struct ScbTest {
    double threshold;
    Stage operator()(const Scb& a, const Scb& b, const Placement& placed) const {
        if constexpr (test == OverlapTest::printed)
            return overlap_figure8<Figure8Errata{true, true}>(a, b, placed, threshold);
        else if constexpr (test == OverlapTest::line8)
            return overlap_figure8<Figure8Errata{false, true}>(a, b, placed, threshold);
        else if constexpr (test == OverlapTest::corrected)
            return overlap_figure8<Figure8Errata{}>(a, b, placed, threshold);
        else if constexpr (test == OverlapTest::symmetric)
            return overlap_symmetric(a, b, placed);
        else
            return overlap_extents(a, b, placed);
    }
};

/// Calls `use` with the test of the options, as one of the types above, and returns its result.
template <Volume V, class Use>
decltype(auto) with_overlap_test(const OverlapOptions& options, Use&& use) {
    if constexpr (std::same_as<V, Ball>) {
        return use(BallTest{});
    } else if constexpr (std::same_as<V, Obb>) {
        return use(ObbTest{});
    } else if constexpr (std::same_as<V, Scb2>) {
        return use(Scb2Test{});
    } else if constexpr (std::same_as<V, Aabb>) {
        return use(AabbTest<false>{});
    } else if constexpr (std::same_as<V, ExactAabb>) {
        return use(AabbTest<true>{});
    } else if constexpr (ConvexVolume<V>) {
        return use(ConvexTest<V>{});
    } else {
        assert(options.threshold >= 0 && options.threshold <= 1 && "a threshold is a cosine");
        switch (options.test) {
            case OverlapTest::printed:
                return use(ScbTest<OverlapTest::printed>{options.threshold});
            case OverlapTest::line8:
                return use(ScbTest<OverlapTest::line8>{options.threshold});
            case OverlapTest::symmetric:
                return use(ScbTest<OverlapTest::symmetric>{options.threshold});
            case OverlapTest::extents:
                return use(ScbTest<OverlapTest::extents>{options.threshold});
            case OverlapTest::corrected:
                break;
        }
        return use(ScbTest<OverlapTest::corrected>{options.threshold});
    }
}

}  // namespace scb
