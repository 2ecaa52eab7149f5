#pragma once

#include <optional>
#include <vector>

#include "core/judge/engine_query.h"

namespace scb {

/// The exact answer of a recorded query.
struct QueryTruth {
    QueryTruth() = default;
    /// Without a distance.
    QueryTruth(std::vector<IndexPair> found) : pairs(std::move(found)) {}

    /// All intersecting pairs of finite triangles or, in a query within a tolerance, all pairs
    /// within it, and in a distance query all pairs as near as the closest; sorted. In a self query
    /// the pairs of SelfPairs; for objects the pairs of object_contacts; empty if only one side has
    /// a mesh.
    std::vector<IndexPair> pairs;
    /// Of a distance query: the smallest distance, and two triangles that have it.
    double distance = HUGE_VAL;
    std::optional<IndexPair> closest{};
    bool certified = false;  ///< a certificate proves the distance
    /// The certified distance of the bodies at their last distance query in an earlier frame.
    std::optional<double> distance_before{};
};

/// What is wrong with the answer of a distance query.
enum class AnswerFault : std::uint8_t {
    none,                 ///< no answer, though triangles are within the limit
    no_number,            ///< the distance is not finite, or negative
    too_large,            ///< triangles are nearer
    too_small,            ///< no triangles are so near
    unknown_triangles,    ///< the mesh does not have them
    triangles_exchanged,  ///< A's triangle is one of B, and B's one of A
    triangles_apart,      ///< the named triangles have another distance
    points_not_finite,
    points_exchanged,       ///< the point of A is on B's triangle, and the other way round
    points_in_body_frames,  ///< each point is in the frame of its body, not of the world
    points_in_frame_of_a,   ///< both points are in A's frame
    point_outside,          ///< a point is not on its triangle
    points_apart,           ///< the points have another distance
};
inline constexpr std::size_t answer_fault_count = 13;

/// A length that explains a wrong distance.
enum class AnswerCause : std::uint8_t {
    unknown,
    square,        ///< the square of the distance
    root,          ///< its square root
    unit,          ///< a multiple, as of another unit of length
    frame_before,  ///< the distance at the frame of the last distance query before
};
inline constexpr std::size_t answer_cause_count = 5;

struct AnswerProblem {
    AnswerFault fault{};
    double recorded = 0, exact = 0;  ///< distances
    IndexPair items{no_index, no_index};
    /// point_outside: 0 for A, 1 for B. points_apart: likewise the body of the wrong point, if the
    /// other point is as far from its triangle as the answer.
    std::optional<std::uint32_t> side{};
    double amount = 0;  ///< point_outside: how far
    AnswerCause cause = AnswerCause::unknown;
    double factor = 1;  ///< unit: the recorded distance over the exact distance
};

/// Compares the answer of a distance query with the exact distance, which must be certified, and
/// its triangles and points with each other. Empty: the answer is right within the tolerance.
std::vector<AnswerProblem> check_answer(const EngineQuery& query, const QueryTruth& truth);

}  // namespace scb
