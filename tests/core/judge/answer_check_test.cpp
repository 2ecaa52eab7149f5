#include "core/judge/answer_check.h"

#include <gtest/gtest.h>

#include <limits>

namespace scb {
namespace {

/// Two triangles of A and two of B, which lie above the first of A at the heights 2 and 3 of A's
/// frame. B's frame is turned about z, and A is moved in the world.
struct Apart {
    Mesh a, b;
    EngineQuery query;
    QueryTruth truth;

    Apart() {
        a.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {8, 9, 9}, {9, 8, 9}};
        b.vertices = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}, {1, 0, 3}, {0, 1, 3}};
        a.triangles = b.triangles = {{0, 1, 2}, {3, 4, 5}};
        query.kind = QueryKind::distance;
        query.b_to_a.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        query.a_to_world.translation = {5, 6, 7};
        query.triangle_tolerance = 1e-12;
        query.sides[0].mesh = &a;
        query.sides[1].mesh = &b;
        truth.distance = 2;
        truth.closest = {0, 0};
        truth.certified = true;
        query.answer = EngineAnswer{2, {0, 0}, std::array<Vec3, 2>{Vec3(5, 6, 7), Vec3(5, 6, 9)}};
    }
    /// The faults that are found.
    std::vector<AnswerFault> faults() const {
        std::vector<AnswerFault> found;
        for (const AnswerProblem& problem : check_answer(query, truth))
            found.push_back(problem.fault);
        return found;
    }
    using Faults = std::vector<AnswerFault>;
};

TEST(AnswerCheck, FindsNothingInARightAnswer) {
    Apart apart;
    EXPECT_EQ(apart.faults(), Apart::Faults{});
    apart.query.answer->points.reset();
    apart.query.answer->items = {no_index, no_index};
    EXPECT_EQ(apart.faults(), Apart::Faults{});
    apart.query.answer->distance += 1e-13;
    EXPECT_EQ(apart.faults(), Apart::Faults{});
}

TEST(AnswerCheck, NamesTheLengthThatAWrongDistanceEquals) {
    const auto cause_of = [](double recorded) {
        Apart apart;
        apart.truth.distance_before = 1.75;
        apart.query.answer->distance = recorded;
        const std::vector<AnswerProblem> found = check_answer(apart.query, apart.truth);
        EXPECT_EQ(found.size(), 1u);
        EXPECT_EQ(found.at(0).fault,
                  recorded > 2 ? AnswerFault::too_large : AnswerFault::too_small);
        return std::pair(found.at(0).cause, found.at(0).factor);
    };
    EXPECT_EQ(cause_of(4), std::pair(AnswerCause::square, 1.0));
    EXPECT_EQ(cause_of(std::sqrt(2.0)), std::pair(AnswerCause::root, 1.0));
    EXPECT_EQ(cause_of(1.75), std::pair(AnswerCause::frame_before, 1.0));
    EXPECT_EQ(cause_of(2000).first, AnswerCause::unit);
    EXPECT_NEAR(cause_of(2000).second, 1000, 1e-9);
    EXPECT_NEAR(cause_of(50.8).second, 25.4, 1e-9);
    EXPECT_EQ(cause_of(2.5), std::pair(AnswerCause::unknown, 1.0));
    // The distance of the named triangles, which are not the closest: no length to explain.
    Apart apart;
    apart.query.answer = EngineAnswer{3, {0, 1}, {}};
    EXPECT_EQ(check_answer(apart.query, apart.truth).at(0).cause, AnswerCause::unknown);
}

TEST(AnswerCheck, KnowsLimitsAndRelativeErrors) {
    Apart apart;
    apart.query.relative_error = 0.5;
    apart.query.answer = EngineAnswer{3, {0, 1}, {}};
    EXPECT_EQ(apart.faults(), Apart::Faults{});
    apart.query.answer->distance = 3.1;
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::too_large});
    apart.query.answer.reset();
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::none});
    apart.query.limit = 1;
    EXPECT_EQ(apart.faults(), Apart::Faults{});
    apart.query.answer = EngineAnswer{1};
    EXPECT_EQ(apart.faults(), Apart::Faults{});
    apart.query.answer = EngineAnswer{0.5};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::too_small});
}

TEST(AnswerCheck, RefusesWhatIsNoDistance) {
    Apart apart;
    for (const double recorded : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -1.0}) {
        apart.query.answer->distance = recorded;
        EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::no_number});
    }
}

TEST(AnswerCheck, NamesWrongTriangles) {
    Apart apart;
    apart.query.answer->points.reset();
    apart.query.answer->items = {0, 1};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::triangles_apart});
    EXPECT_EQ(check_answer(apart.query, apart.truth).at(0).exact, 3);
    apart.query.answer->items = {0, 7};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::unknown_triangles});
    apart.a.triangles = {{3, 4, 5}, {0, 1, 2}};
    apart.query.answer->items = {0, 1};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::triangles_exchanged});
}

TEST(AnswerCheck, NamesTheFrameOfPoints) {
    Apart apart;
    auto& [of_a, of_b] = *apart.query.answer->points;
    std::swap(of_a, of_b);
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::points_exchanged});
    // A corner that the rotation of B moves.
    of_a = {0, 1, 0};
    of_b = {1, 0, 2};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::points_in_body_frames});
    of_b = {-1, 0, 2};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::points_in_frame_of_a});
    of_a = {5, 6, 7};
    of_b = {5, 6, 9.5};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::point_outside});
    EXPECT_EQ(check_answer(apart.query, apart.truth).at(0).side, 1u);
    EXPECT_NEAR(check_answer(apart.query, apart.truth).at(0).amount, 0.5, 1e-12);
    of_b = {5, 7, 9};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::points_apart});
    EXPECT_FALSE(check_answer(apart.query, apart.truth).at(0).side) << "either may be wrong";
    of_b = {5, std::numeric_limits<double>::quiet_NaN(), 9};
    EXPECT_EQ(apart.faults(), Apart::Faults{AnswerFault::points_not_finite});
}

}  // namespace
}  // namespace scb
