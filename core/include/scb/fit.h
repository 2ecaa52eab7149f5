#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/scb.h"
#include "scb/scb2.h"
#include "scb/simd_level.h"
#include "scb/vec.h"

namespace scb {

/// How the minimum ball of the extremal points is grown over all points (Figure 3, line 4).
enum class BallGrowth {
    radius,  ///< the center stays, the radius grows
    ritter,  ///< each point outside moves the center towards itself, as in Ritter's ball
};

/// How a Ball is fitted. The ball of an Scb is always `minimum`.
enum class BallMethod {
    minimum,  ///< Figure 3, lines 1 to 6: the minimum ball of the extremal points, grown
    ritter,   ///< Ritter's ball (Section 5, last comparison)
};

/// The work of fits, summed; it shows that the work is linear.
struct FitCounts {
    std::uint64_t point_visits =
        0;  ///< points visited by all passes of the ball's fit and for all slabs tried
    std::uint64_t candidate_slabs = 0;  ///< slabs tried besides the DOP's

    /// Adds the counts of other fits.
    void add(const FitCounts& other) {
        point_visits += other.point_visits;
        candidate_slabs += other.candidate_slabs;
    }
};

/// "ritter", "radius": the names of the command line.
std::string_view ball_growth_name(BallGrowth growth);

/// How volumes are fitted. Options that a kind of volume does not use are ignored.
struct FitOptions {
    /// Over the measured models, Ritter's shift made some 2 % of the larger nodes smaller and
    /// hardly any larger (summed area -0.05 %), at the same cost.
    BallGrowth growth = BallGrowth::ritter;
    /// How a Ball is fitted.
    BallMethod ball_method = BallMethod::minimum;
    /// The error margin of Section 2, as a share of the radius: both planes of a slab move outward
    /// by margin * r, but not out of the ball.
    double margin = 0;
    /// Where to add the work of the fits; nowhere by default.
    FitCounts* counts = nullptr;
    /// Which vector instructions to use; volumes are the same for any.
    SimdLevel simd = SimdLevel::best;
};

/// Fits the volume to the points; every point satisfies `contains` exactly.
///
/// Scb: Figure 3 of the paper, O(n). Minimum ball of the at most 26 extremal points of the 26-DOP
/// (of all points where n <= 26; n counts distinct positions in a hierarchy), grown over all
/// points; the narrowest slab among the DOP's 13 and the planes through an extremal pair and the
/// extremal point (where n <= 26 any point) farthest from their line. A pair that coincides, or
/// whose points are all collinear, gives no plane. `f <= 0 <= e`, both within the radius.
///
/// Scb2: the same ball and slab; the second slab is the narrowest at right angles to it for the
/// extremal points (for all points if n <= 26).
///
/// Ball: the same ball, or Ritter's.
///
/// Obb: axes from the area-weighted covariance of the triangles (Gottschalk, Lin, Manocha,
/// "OBBTree", 1996, as in RAPID), or of the points if there are no triangles or they have no area;
/// the box along these axes is as small as possible.
///
/// At least one point, all finite: throws InputError otherwise.
Scb fit_scb(std::span<const Vec3> points, const FitOptions& options = {});
/// The same for a ball cut by two slabs, see `fit_scb`.
Scb2 fit_scb2(std::span<const Vec3> points, const FitOptions& options = {});
/// The same for a ball, see `fit_scb`.
Ball fit_ball(std::span<const Vec3> points, const FitOptions& options = {});
/// The same for an oriented box, see `fit_scb`.
Obb fit_obb(std::span<const Vec3> points, const FitOptions& options = {});

}  // namespace scb
