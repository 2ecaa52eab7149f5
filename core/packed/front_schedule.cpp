#include "core/packed/front_schedule.h"

#include <algorithm>
#include <cmath>

#include "core/packed/packed_query.h"
#include "scb/packed_front.h"

namespace scb {
namespace {

// A front costs about as much as a query. The thicker its skin, the more pairs it has that are
// apart. If queries move by d, a front with skin s is valid for a number of queries proportional to
// s / d. Each of them has more tests, by a share proportional to s / leaf_radius. The total cost is
// least for a skin proportional to the root of d leaf_radius. The factor was measured, and so was
// the largest motion for which a front pays: on surfaces that cross (horses, hands) and on surfaces
// that nearly coincide (spheres).
constexpr double skin_factor = 0.1, most_motion = 0.025;
/// The least skin, in units of leaf_radius: it adds no measurable cost.
constexpr double least_skin = 1e-3;
/// A front pays if it serves at least this many queries.
constexpr int paid = 2;
constexpr int longest_pause = 63;
constexpr int most_ahead = 32;

Pose product(const Pose& outer, const Pose& inner) {
    Pose result;
    for (int k = 0; k < 3; ++k)
        result.rotation.col(k) = rotate(outer.rotation, Vec3(inner.rotation.col(k)));
    result.translation = transform_point(outer, inner.translation);
    return result;
}

/// The motion that leads from one pose to the other, in A's frame.
Pose step(const Pose& from, const Pose& to) { return product(to, inverse(from)); }

}  // namespace

double motion_bound(const FrontBodies& bodies, const Pose& from, const Pose& to) {
    const double of_b = displacement_bound(from, to, bodies.b);
    // Distances are the same in B's frame, except for rounding and defects of the poses. The bound
    // has to include these once again: 7 defects and 32 units of these lengths, and more.
    const double of_a = displacement_bound(inverse(from), inverse(to), bodies.a);
    const double lengths = std::sqrt(squared_norm(from.translation)) +
                           std::sqrt(squared_norm(to.translation)) +
                           std::sqrt(squared_norm(bodies.a.center)) + bodies.a.radius +
                           std::sqrt(squared_norm(bodies.b.center)) + bodies.b.radius;
    const double defects = rigidity_defect(from) + rigidity_defect(to);
    return std::min(of_b, of_a + (8 * defects + 64 * 0x1p-53) * lengths);
}

std::optional<FrontPlan> FrontSchedule::next(const FrontBodies& bodies, const Pose& b_to_a,
                                             double rounding) {
    const auto is_good = [&](const FrontPlan& front) {
        return motion_bound(bodies, front.b_to_a, b_to_a) + rounding <= front.skin;
    };
    std::optional<FrontPlan> made_now;
    good_ = front_ && is_good(*front_);
    if (!good_) {
        made_now = plan(bodies, b_to_a, rounding);
        if (made_now && !is_good(*made_now)) made_now.reset();
        if (made_now) {
            front_ = made_now;
            good_ = true;
            uses_ = 0;
            ++made;
        }
    }
    if (good_) {
        ++uses_;
        ++used;
    }
    before_last_ = last_;
    last_ = b_to_a;
    return made_now;
}

std::optional<FrontPlan> FrontSchedule::plan(const FrontBodies& bodies, const Pose& b_to_a,
                                             double rounding) {
    if (!last_) return std::nullopt;
    const double motion = motion_bound(bodies, *last_, b_to_a);
    if (!(motion <= most_motion * bodies.leaf_radius)) return std::nullopt;
    // If no front can follow the motion, pauses between attempts grow.
    const bool has_paid = !front_ || uses_ >= paid;
    if (has_paid) pause_ = next_pause_ = 0;
    if (pause_ > 0) {
        --pause_;
        return std::nullopt;
    }
    if (!has_paid) pause_ = next_pause_ = std::min(2 * next_pause_ + 1, longest_pause);
    const double skin = std::max(std::sqrt(skin_factor * motion * bodies.leaf_radius),
                                 least_skin * bodies.leaf_radius) +
                        2 * rounding;
    // All points coincide: a front needs a skin.
    if (!(skin > 0)) return std::nullopt;
    // If the motion goes on as before, a front at a pose ahead is valid before and after this pose.
    if (!before_last_) return FrontPlan{b_to_a, skin};
    const Pose on = step(*last_, b_to_a);
    if (motion_bound(bodies, product(step(*before_last_, *last_), *last_), b_to_a) > motion / 4)
        return FrontPlan{b_to_a, skin};
    Pose ahead = b_to_a;
    double left = skin - 2 * rounding - motion;
    for (int i = 0; i < most_ahead && left >= 0; ++i, left -= motion) ahead = product(on, ahead);
    return FrontPlan{ahead, skin};
}

double displacement_bound(const Pose& from, const Pose& to, const Ball& body) {
    // A point c + d moves by (R1 c + t1 - R0 c - t0) + (R1 - R0) d. For rotations, R1 - R0 is (Q -
    // I) R0 with Q their quotient, a turn by some angle: its singular values are 0 and twice 2
    // sin(angle / 2), so it stretches d by its Frobenius norm over sqrt(2) at most.
    //
    // If |R^T R - I| <= defect in each entry, singular values differ from 1 by 3 defect. The matrix
    // differs from a rotation by 3 defect in how far it stretches d, and by 3 sqrt(3) defect in the
    // Frobenius norm: (3 + 3 sqrt(3 / 2)) defect for each matrix, below 7.
    double squares = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double difference = to.rotation(i, j) - from.rotation(i, j);
            squares += difference * difference;
        }
    const double defects = rigidity_defect(from) + rigidity_defect(to);
    const double turn = std::sqrt(squares / 2) + 7 * defects;
    const Vec3 center = body.center;
    const double moved =
        std::sqrt(squared_norm(transform_point(to, center) - transform_point(from, center)));
    // Images of the center are off by a few units in the last place of their terms, entries of the
    // difference by half a unit of 1: 32 units are more than twice the sum of these errors.
    const double lengths = 2 * std::sqrt(squared_norm(center)) + 2 * body.radius +
                           std::sqrt(squared_norm(from.translation)) +
                           std::sqrt(squared_norm(to.translation));
    return moved + turn * body.radius + 32 * 0x1p-53 * lengths;
}

PackedFront::PackedFront() : parts_(std::make_unique<Parts>()) {}
PackedFront::~PackedFront() = default;
PackedFront::PackedFront(PackedFront&&) noexcept = default;
PackedFront& PackedFront::operator=(PackedFront&&) noexcept = default;

void PackedFront::clear() {
    parts_->schedule = {};
    parts_->pairs.clear();
    parts_->met.reset();
}

std::uint64_t PackedFront::made() const { return parts_->schedule.made; }
std::uint64_t PackedFront::used() const { return parts_->schedule.used; }

}  // namespace scb
