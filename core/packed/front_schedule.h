#pragma once

#include <cstdint>
#include <optional>

#include "scb/ball.h"
#include "scb/pose.h"

namespace scb {

/// What of two bodies decides on their front.
struct FrontBodies {
    Ball a, b;               ///< that all of A and of B is in, each in its own frame
    double leaf_radius = 0;  ///< of a typical leaf of A and one of B, the sum
};

/// No two points of A and B have come nearer by more than this, or gone farther, from the one pose
/// of B in A's frame to the other: the lesser bound of how B has moved, seen from A, and A from B.
double motion_bound(const FrontBodies& bodies, const Pose& from, const Pose& to);

/// A front that is to be made.
struct FrontPlan {
    Pose b_to_a;
    double skin = 0;  ///< a length
};

/// Decides when a PackedFront is made, by the poses of the queries, which must be told one by one.
class FrontSchedule {
  public:
    /// The front to make for a query, which is good for it; nothing where the last one is, or where
    /// none would pay. `rounding` is a length that points may be off by at the pose, see Placement.
    std::optional<FrontPlan> next(const FrontBodies& bodies, const Pose& b_to_a, double rounding);

    /// Whether a front has been planned that is good for the query of the last call.
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

}  // namespace scb
