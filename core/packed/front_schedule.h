#pragma once

#include <cstdint>
#include <optional>

#include "scb/ball.h"
#include "scb/pose.h"

namespace scb {

/// The measures of two bodies on which their front depends.
struct FrontBodies {
    Ball a, b;               ///< contain all of A and of B, each in its own frame
    double leaf_radius = 0;  ///< the sum for a typical leaf of A and one of B
};

/// An upper bound of the change of distance between any two points of A and B, from one pose of B
/// in A's frame to the other: the smaller bound of the motion of B seen from A, and of A seen from
/// B.
double motion_bound(const FrontBodies& bodies, const Pose& from, const Pose& to);

/// A front to be made.
struct FrontPlan {
    Pose b_to_a;
    double skin = 0;  ///< a length
};

/// Decides when a PackedFront is made, from the poses of the queries, which it must receive one by
/// one.
class FrontSchedule {
  public:
    /// The front to make for a query, which is valid for it. Nothing if the last front is valid, or
    /// if no front would pay. `rounding` is an upper bound of the error of points at the pose, see
    /// Placement.
    std::optional<FrontPlan> next(const FrontBodies& bodies, const Pose& b_to_a, double rounding);

    /// Whether the planned front is valid for the query of the last call.
    bool is_good() const { return good_; }

    std::uint64_t made = 0, used = 0;

  private:
    std::optional<FrontPlan> plan(const FrontBodies& bodies, const Pose& b_to_a, double rounding);

    std::optional<FrontPlan> front_;
    bool good_ = false;
    std::optional<Pose> last_, before_last_;
    int uses_ = 0;  // of the front
    int pause_ = 0, next_pause_ = 0;
};

/// An upper bound of the distance between any point of the ball, in the body frame, at the pose
/// `from` and the same point at the pose `to`, both in one frame. Not much above the least bound if
/// the body's turn is small, or if the ball's center moves as its surface does. Infinite if
/// rigidity_defect is infinite for a pose; smaller defects are included in the bound.
double displacement_bound(const Pose& from, const Pose& to, const Ball& body);

}  // namespace scb
