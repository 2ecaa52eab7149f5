#include "core/judge/tree_watch.h"

#include <utility>

namespace scb {

void TreeWatch::look(int frame, const NodeTree& tree, const TreeShape& shape, const Mesh* mesh,
                     double tolerance, int version, int volume_version) {
    if (frame == looked_ && version == version_ && volume_version == volume_version_) return;
    if (version != version_) {
        version_ = version;
        std::vector<TreeProblem> found = check_shape(tree, shape, mesh);
        if (found != shape_problems_)
            for (const TreeProblem& problem : found)
                of_shape_.push_back({problem, words_of(problem, tree), frame, frame});
        shape_problems_ = std::move(found);
    }
    if (volume_version == volume_version_) {
        if (frame != looked_)
            for (const std::size_t i : present_) ++of_volumes_[i].frames;
        looked_ = frame;
        return;
    }
    volume_version_ = volume_version;
    present_.clear();
    for (const TreeProblem& problem : check_volumes(tree, shape, mesh, tolerance)) {
        const auto [known, added] = by_node_.try_emplace(problem.node, of_volumes_.size());
        present_.push_back(known->second);
        const int told_at = tree[tree.index_of(problem.node)].told_at;
        if (added) {
            of_volumes_.push_back(
                {problem, words_of(problem, tree), frame, told_at, looked_ >= told_at});
            continue;
        }
        WatchedProblem& before = of_volumes_[known->second];
        before.frames += frame != looked_;
        if (problem.amount > before.problem.amount) {
            before.problem = problem;
            before.words = words_of(problem, tree);
        }
    }
    looked_ = frame;
}

std::vector<WatchedProblem> TreeWatch::problems() const {
    std::vector<WatchedProblem> all = of_shape_;
    all.insert(all.end(), of_volumes_.begin(), of_volumes_.end());
    return all;
}

}  // namespace scb
