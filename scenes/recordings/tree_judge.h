#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>

#include "core/judge/tree_watch.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::scenes {

/// Judges the trees of a recording frame by frame.
class TreeJudge {
  public:
    /// The recording must outlive this.
    explicit TreeJudge(RecordedQueries& recording) : recording_(recording) {}

    /// Checks the current tree, and looks for the reason if many nodes do not contain what is below
    /// them.
    void look(std::uint32_t number, const std::map<std::uint32_t, std::string>& body_names);
    /// By number.
    const std::map<std::uint32_t, TreeWatch>& watches() const { return watches_; }
    /// The judgements at the end, by number.
    std::vector<TreeJudgement> judged();

  private:
    struct EarlierMesh {
        int version = 0, frame = 0;
        std::shared_ptr<const Mesh> mesh;
    };
    struct TreeFitting {
        std::optional<TreeFit> fit;
        std::size_t outside = 0;
        int tries = 0, frame = 0;
    };

    void keep_mesh(std::uint32_t number, const MeshState& mesh);
    void find_fit(std::uint32_t number, const EngineSide& side, const MeshState& mesh,
                  double tolerance, const std::map<std::uint32_t, std::string>& body_names);

    RecordedQueries& recording_;
    std::map<std::uint32_t, TreeWatch> watches_;
    std::map<std::uint32_t, std::deque<EarlierMesh>> earlier_;  ///< by mesh
    std::map<std::uint32_t, TreeFitting> fits_;                 ///< by tree
};

}  // namespace scb::scenes
