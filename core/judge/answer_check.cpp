#include "core/judge/answer_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/judge/item_contact.h"
#include "scb/pose.h"
#include "scb/triangle_distance.h"

namespace scb {
namespace {

/// Lengths of units, in meters, that engines and models are written in.
constexpr std::array<double, 6> units = {1, 0.1, 0.01, 0.001, 0.0254, 0.3048};

class AnswerCheck {
  public:
    AnswerCheck(const EngineQuery& query, const QueryTruth& truth)
        : query_(query), truth_(truth), tolerance_(query.triangle_tolerance) {}

    std::vector<AnswerProblem> problems() && {
        if (!query_.answer) {
            // A query that ended early need not have found anything.
            if (query_.complete &&
                (1 + query_.relative_error) * truth_.distance < query_.limit - tolerance_)
                add(AnswerFault::none);
            return std::move(problems_);
        }
        // Beyond the limit an engine may return any number that is no distance below the limit.
        if (truth_.distance > query_.limit &&
            (query_.answer->distance >= query_.limit - tolerance_ || query_.answer->distance < 0))
            return {};
        // Some engines return a depth, as a negative number, for bodies that meet.
        if (truth_.distance <= tolerance_ && query_.answer->distance < 0) return {};
        if (check_distance()) return std::move(problems_);
        const bool has_items =
            query_.answer->items.a != no_index && query_.answer->items.b != no_index;
        if (has_items) check_triangles();
        // Of bodies that meet, engines define no closest points.
        if (query_.answer->points && truth_.distance > tolerance_)
            check_points(has_items && problems_.empty());
        return std::move(problems_);
    }

  private:
    void add(AnswerFault fault) {
        AnswerProblem problem{fault};
        problem.recorded = query_.answer ? query_.answer->distance : HUGE_VAL;
        problem.exact = truth_.distance;
        if (query_.answer) problem.items = query_.answer->items;
        problems_.push_back(problem);
    }

    /// Whether a length explains a recorded number. Lengths within the tolerance explain nothing.
    bool is_near(double recorded, double length) const {
        return length > 4 * tolerance_ &&
               std::abs(recorded - length) <= std::max(tolerance_, 1e-9 * length);
    }

    /// Whether the distance is wrong.
    bool check_distance() {
        const double recorded = query_.answer->distance, exact = truth_.distance;
        if (!std::isfinite(recorded) || recorded < -tolerance_)
            add(AnswerFault::no_number);
        else if (query_.complete && recorded > (1 + query_.relative_error) * exact + tolerance_)
            add(AnswerFault::too_large);
        else if (recorded < exact - tolerance_)
            add(AnswerFault::too_small);
        else
            return false;
        if (problems_.back().fault != AnswerFault::no_number) explain(problems_.back());
        return true;
    }

    /// Names the length that the wrong distance equals. If the named triangles have another
    /// distance than the closest ones, their distance counts.
    void explain(AnswerProblem& problem) const {
        double length = problem.exact;
        if (has_triangles()) length = distance_of(query_.answer->items);
        const double recorded = problem.recorded;
        if (!(length > tolerance_) || is_near(recorded, length)) return;
        if (truth_.distance_before && is_near(recorded, *truth_.distance_before)) {
            problem.cause = AnswerCause::frame_before;
        } else if (is_near(recorded, length * length)) {
            problem.cause = AnswerCause::square;
        } else if (is_near(recorded, std::sqrt(length))) {
            problem.cause = AnswerCause::root;
        } else {
            for (const double from : units)
                for (const double to : units)
                    if (from != to && is_near(recorded, length * (from / to))) {
                        problem.cause = AnswerCause::unit;
                        problem.factor = from / to;
                        return;
                    }
        }
    }

    bool has_triangles() const {
        return query_.answer->items.a != no_index && has_items(query_, query_.answer->items) &&
               are_finite(query_, query_.answer->items);
    }

    std::array<TriangleCorners, 2> triangles(IndexPair items) const {
        return {corners(*query_.sides[0].mesh, items.a),
                transform_corners(query_.b_to_a, corners(*query_.sides[1].mesh, items.b))};
    }

    double distance_of(IndexPair items) const {
        const auto [a, b] = triangles(items);
        return triangle_distance(a, b).distance;
    }

    /// The answer may exceed the distance of the triangles by the relative error.
    bool has_distance(double length) const {
        return std::abs(query_.answer->distance - length) <=
               tolerance_ + query_.relative_error * length;
    }

    void check_triangles() {
        const IndexPair items = query_.answer->items, exchanged{items.b, items.a};
        const bool exist = has_items(query_, items);
        if (exist && (!are_finite(query_, items) || has_distance(distance_of(items)))) return;
        if (has_items(query_, exchanged) && are_finite(query_, exchanged) &&
            has_distance(distance_of(exchanged)))
            return add(AnswerFault::triangles_exchanged);
        if (!exist) return add(AnswerFault::unknown_triangles);
        add(AnswerFault::triangles_apart);
        problems_.back().exact = distance_of(items);
    }

    static double away(const Vec3& point, const TriangleCorners& triangle) {
        return triangle_distance({point, point, point}, triangle).distance;
    }

    /// How far two points in A's frame are from the named triangles.
    std::array<double, 2> outside(const Vec3& of_a, const Vec3& of_b) const {
        const auto [a, b] = triangles(query_.answer->items);
        return {away(of_a, a), away(of_b, b)};
    }

    void check_points(bool has_known_items) {
        const auto& [of_a, of_b] = *query_.answer->points;
        if (!is_usable(of_a) || !is_usable(of_b)) return add(AnswerFault::points_not_finite);
        const Pose to_a = relative_pose(query_.a_to_world, Pose{});
        const Vec3 in_a = transform_point(to_a, of_a), in_a_of_b = transform_point(to_a, of_b);
        const bool has_items = has_known_items && are_finite(query_, query_.answer->items);
        if (has_items) {
            const auto fits = [&](const Vec3& a, const Vec3& b) {
                const std::array<double, 2> far = outside(a, b);
                return std::max(far[0], far[1]) <= tolerance_;
            };
            if (!fits(in_a, in_a_of_b)) {
                if (fits(in_a_of_b, in_a)) return add(AnswerFault::points_exchanged);
                if (fits(of_a, transform_point(query_.b_to_a, of_b)))
                    return add(AnswerFault::points_in_body_frames);
                if (fits(of_a, of_b)) return add(AnswerFault::points_in_frame_of_a);
                const std::array<double, 2> far = outside(in_a, in_a_of_b);
                add(AnswerFault::point_outside);
                const std::uint32_t side = far[0] > tolerance_ ? 0 : 1;
                problems_.back().side = side;
                problems_.back().amount = far[side];
                return;
            }
        }
        const double between = std::sqrt(squared_norm(Vec3(in_a_of_b - in_a)));
        if (has_distance(between)) return;
        add(AnswerFault::points_apart);
        problems_.back().exact = between;
        if (!has_items) return;
        const auto [a, b] = triangles(query_.answer->items);
        const bool is_near_b = has_distance(away(in_a, b)),
                   is_near_a = has_distance(away(in_a_of_b, a));
        if (is_near_a != is_near_b) problems_.back().side = is_near_b ? 1 : 0;
    }

    const EngineQuery& query_;
    const QueryTruth& truth_;
    const double tolerance_;
    std::vector<AnswerProblem> problems_;
};

}  // namespace

std::vector<AnswerProblem> check_answer(const EngineQuery& query, const QueryTruth& truth) {
    return AnswerCheck(query, truth).problems();
}

}  // namespace scb
