#pragma once

#include <map>
#include <set>
#include <tuple>

#include "core/judge/tree_check.h"

namespace scb {

/// A problem of a tree, and the frames that have it.
struct WatchedProblem {
    TreeProblem problem;      ///< a problem of a volume: as in its worst frame
    std::string words;        ///< a clause, see words_of
    int since = 0;            ///< the first frame
    double since_amount = 0;  ///< a problem of a volume: its amount in that frame
    int worst_at = 0;         ///< the frame at which it is worst
    /// An earlier frame had the same volume, and it was right then, or at most half as wrong.
    bool stale = false;
    int recorded_at = 0;       ///< the frame at which the wrong volume was recorded
    std::uint64_t frames = 1;  ///< number of checked frames with the problem
    int last = 0;              ///< the last of these frames
    bool gaps = false;         ///< a frame between the first and the last is without the problem
    /// The frame at which the node got other children or items, and the earlier frame whose volume
    /// it kept; -1: did not happen.
    int links_at = -1, kept_from = -1;
};

/// A tree to check, with counters of its recorded changes.
struct WatchedTree {
    const EngineNodes& tree;
    const TreeShape& shape;
    const Mesh* mesh = nullptr;
    NodeTolerance tolerance = 0;
    int version = 0;         ///< counts changes of the shape
    int volume_version = 0;  ///< counts changes of anything that affects containment
};

/// Checks a tree frame by frame. Unchanged parts are not checked again.
class TreeWatch {
  public:
    void look(int frame, const WatchedTree& tree);

    /// Problems of the shape come first. Problems of volumes follow by amount, the largest first,
    /// and inherited problems last. Of equal amounts, the node farthest from the root comes first.
    std::vector<WatchedProblem> problems() const;
    const UnjudgedVolumes& unjudged() const { return unjudged_; }
    /// The largest number of nodes in a frame that did not contain what is below them, and the
    /// first such frame.
    std::size_t most_outside() const { return most_outside_; }
    int most_outside_at() const { return most_outside_at_; }

  private:
    void look_at_shape(int frame, const WatchedTree& tree);
    void note(int frame, const WatchedTree& tree, const TreeProblem& problem);

    int version_ = -1, volume_version_ = -1;
    int looked_ = -1;  ///< the latest frame
    /// Fault, node, other and item of each problem of the shape.
    std::set<std::tuple<TreeFault, std::uint32_t, std::uint32_t, std::uint32_t>> known_shapes_;
    std::vector<WatchedProblem> of_shape_, of_volumes_;
    std::map<std::uint32_t, std::size_t> by_node_;  ///< number to index into of_volumes_
    std::vector<std::size_t> present_;         ///< indices into of_volumes_, at the latest look
    std::map<std::uint32_t, double> amounts_;  ///< by node number, at the latest look
    UnjudgedVolumes unjudged_;                 ///< the largest counts of any look
    std::size_t most_outside_ = 0;
    int most_outside_at_ = 0;
};

}  // namespace scb
