#include "scenes/recordings/pose_search.h"

#include <algorithm>
#include <map>
#include <utility>

namespace scb::scenes {
namespace {

/// Other poses that the tests may have been made with, the likeliest first.
std::vector<std::pair<std::string, Pose>> other_poses(const EngineQuery& query, const Pose& a,
                                                      const Pose& b) {
    std::vector<std::pair<std::string, Pose>> others;
    if (query.b_to_a_before)
        others.emplace_back("the pose of the frame before", *query.b_to_a_before);
    const auto transposed = [](const Pose& pose) {
        return Pose{pose.rotation.transpose(), pose.translation};
    };
    const Pose& pose = query.b_to_a;
    others.emplace_back("the pose with its rotation transposed", transposed(pose));
    const Mat3 turned = pose.rotation.transpose();
    others.emplace_back("the inverse of the pose", Pose{turned, -rotate(turned, pose.translation)});
    others.emplace_back("the poses with the rotation of B transposed",
                        relative_pose(a, transposed(b)));
    others.emplace_back("the poses with the rotation of A transposed",
                        relative_pose(transposed(a), b));
    others.emplace_back("the poses with both rotations transposed",
                        relative_pose(transposed(a), transposed(b)));
    others.emplace_back("the pose without its rotation", Pose{Mat3::Identity(), pose.translation});
    others.emplace_back("the pose without its translation", Pose{pose.rotation, Vec3::Zero()});
    return others;
}

/// Whether some tests passed and some rejected: tests of one outcome fit many poses.
bool has_both_outcomes(const EngineQuery& query) {
    bool meet = false, apart = false;
    for (const EngineEvent& event : query.events) {
        const bool passed = event.kind == EngineEvent::Kind::volumes
                                ? event.stage == 0
                                : event.kind != EngineEvent::Kind::items_apart;
        (passed ? meet : apart) = true;
    }
    return meet && apart;
}

}  // namespace

bool PoseSearch::fits(const EngineQuery& query, const Pose& with, const QueryName& name,
                      const std::string& what, bool only_volumes, const PoseFit& told) {
    const PoseFit found = fit_of_pose(query, with);
    if (found.wrong > 0 || found.false_positive > told.false_positive) return false;
    if (only_volumes ? told.wrong_items > 0 || told.wrong == 0 : found.wrong_items > 0)
        return false;
    found_.push_back({name, what, told, found, only_volumes});
    return true;
}

void PoseSearch::take(const EngineQuery& query, const QueryName& name, const BodyState& a,
                      const BodyState& b) {
    if (!has_both_outcomes(query)) return;
    ++queries_;
    const PoseFit told = fit_of_pose(query, query.b_to_a);
    const auto others = other_poses(query, a.pose, b.pose);
    for (const auto& [what, other] : others)
        if (fits(query, other, name, what, false, told)) return;
    EngineQuery swapped = query;
    for (EngineEvent& event : swapped.events) std::swap(event.a, event.b);
    if (fits(swapped, query.b_to_a, name,
             "the recorded pose if each names a node of " + name.b + " first, and of " + name.a +
                 " second, in the other order than the query",
             false, told))
        return;
    for (const auto& [what, other] : others)
        if (fits(query, other, name, what, true, told)) return;
    not_placed_ |= !a.placed && !b.placed;
}

std::vector<PoseProblem> PoseSearch::likely() const {
    std::map<std::string, std::size_t> counts;
    for (const PoseProblem& problem : found_) ++counts[problem.pose];
    std::vector<PoseProblem> kept = found_;
    std::erase_if(kept,
                  [&](const PoseProblem& problem) { return 2 * counts[problem.pose] <= queries_; });
    return kept;
}

}  // namespace scb::scenes
