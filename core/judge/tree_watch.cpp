#include "core/judge/tree_watch.h"

#include <algorithm>
#include <utility>

namespace scb {

void TreeWatch::look_at_shape(int frame, const WatchedTree& tree) {
    version_ = tree.version;
    for (const TreeProblem& problem : check_shape(tree.tree, tree.shape, tree.mesh)) {
        const auto key = std::tuple(problem.fault, problem.node, problem.other, problem.item);
        if (known_shapes_.insert(key).second)
            of_shape_.push_back(
                {problem, words_of(problem, tree.tree), frame, 0, frame, false, frame});
    }
}

void TreeWatch::note(int frame, const WatchedTree& tree, const TreeProblem& problem) {
    const EngineNode& node = tree.tree[tree.tree.index_of(problem.node)];
    const auto last = amounts_.find(problem.node);
    const double before = last == amounts_.end() ? 0 : last->second;
    const bool stale =
        node.recorded_at < frame && looked_ >= node.recorded_at && 2 * before <= problem.amount;
    const auto [known, added] = by_node_.try_emplace(problem.node, of_volumes_.size());
    present_.push_back(known->second);
    if (added)
        of_volumes_.push_back({problem, words_of(problem, tree.tree), frame, problem.amount, frame,
                               stale, node.recorded_at});
    WatchedProblem& watched = of_volumes_[known->second];
    if (!added) {
        watched.frames += frame != looked_;
        watched.gaps |= watched.last != looked_;
    }
    watched.last = frame;
    watched.problem.inherited = watched.problem.inherited && problem.inherited;
    if (watched.links_at < 0 && node.links_at > node.recorded_at) {
        watched.links_at = node.links_at;
        watched.kept_from = node.recorded_at;
    }
    if (added || !(problem.amount > watched.problem.amount)) return;
    // A newer volume than the stale one may be wrong, too.
    if (stale || node.recorded_at > watched.recorded_at) {
        watched.stale = stale;
        watched.recorded_at = node.recorded_at;
    }
    const bool inherited = watched.problem.inherited;
    watched.problem = problem;
    watched.problem.inherited = inherited;
    watched.words = words_of(problem, tree.tree);
    watched.worst_at = frame;
}

void TreeWatch::look(int frame, const WatchedTree& tree) {
    if (frame == looked_ && tree.version == version_ && tree.volume_version == volume_version_)
        return;
    if (tree.version != version_) look_at_shape(frame, tree);
    if (tree.volume_version == volume_version_) {
        if (frame != looked_)
            for (const std::size_t i : present_) {
                ++of_volumes_[i].frames;
                of_volumes_[i].last = frame;
            }
        looked_ = frame;
        return;
    }
    volume_version_ = tree.volume_version;
    present_.clear();
    UnjudgedVolumes unjudged;
    const std::vector<TreeProblem> problems =
        check_volumes(tree.tree, tree.shape, tree.mesh, tree.tolerance, &unjudged);
    std::map<std::uint32_t, double> amounts;
    std::size_t outside = 0;
    for (const TreeProblem& problem : problems) {
        note(frame, tree, problem);
        amounts.emplace(problem.node, problem.amount);
        outside += problem.fault == TreeFault::outside;
    }
    amounts_ = std::move(amounts);
    if (outside > most_outside_) {
        most_outside_ = outside;
        most_outside_at_ = frame;
    }
    unjudged_.leaves = std::max(unjudged_.leaves, unjudged.leaves);
    unjudged_.of_leaves = std::max(unjudged_.of_leaves, unjudged.of_leaves);
    unjudged_.slightly_open = std::max(unjudged_.slightly_open, unjudged.slightly_open);
    unjudged_.open_by = std::max(unjudged_.open_by, unjudged.open_by);
    unjudged_.dropped = std::max(unjudged_.dropped, unjudged.dropped);
    unjudged_.splits = std::max(unjudged_.splits, unjudged.splits);
    unjudged_.of_splits = std::max(unjudged_.of_splits, unjudged.of_splits);
    looked_ = frame;
}

std::vector<WatchedProblem> TreeWatch::problems() const {
    std::vector<WatchedProblem> all = of_shape_, of_volumes = of_volumes_;
    // Problems of one look come deepest node first, and the sort keeps that order.
    std::stable_sort(of_volumes.begin(), of_volumes.end(),
                     [](const WatchedProblem& x, const WatchedProblem& y) {
                         if (x.problem.inherited != y.problem.inherited) return y.problem.inherited;
                         return x.problem.amount > y.problem.amount;
                     });
    all.insert(all.end(), of_volumes.begin(), of_volumes.end());
    return all;
}

}  // namespace scb
