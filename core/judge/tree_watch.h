#pragma once

#include <map>

#include "core/judge/tree_check.h"

namespace scb {

/// A problem of a tree, and when it was there.
struct WatchedProblem {
    TreeProblem problem;       ///< of a volume: where it is worst
    std::string words;         ///< a clause, see words_of
    int since = 0;             ///< the first frame
    int told_at = 0;           ///< the frame at which the volume was told that was wrong first
    bool stale = false;        ///< the same volume contained all in an earlier frame
    std::uint64_t frames = 1;  ///< in how many of the frames that were looked at
};

/// Checks a tree frame by frame.
class TreeWatch {
  public:
    /// `version` and `volume_version` count how often the tree, or anything that decides what it
    /// contains, changed: what did not is not checked again.
    void look(int frame, const NodeTree& tree, const TreeShape& shape, const Mesh* mesh,
              double tolerance, int version, int volume_version);

    /// Those of the shape, then those of volumes: the first frame first, and there the farthest
    /// from the root.
    std::vector<WatchedProblem> problems() const;

  private:
    int version_ = -1, volume_version_ = -1;
    int looked_ = -1;                          ///< frame
    std::vector<TreeProblem> shape_problems_;  ///< at the last look
    std::vector<WatchedProblem> of_shape_, of_volumes_;
    std::map<std::uint32_t, std::size_t> by_node_;  ///< number to index into of_volumes_
    std::vector<std::size_t> present_;              ///< at the last look
};

}  // namespace scb
