#pragma once

#include <string>
#include <vector>

#include "core/judge/pose_fit.h"
#include "scenes/recordings/recorded_queries.h"

namespace scb::scenes {

/// A query of a recording.
struct QueryName {
    int frame = 0;
    std::string a, b;    ///< bodies
    std::string name{};  ///< of the query itself, as recorded; mostly empty
};

/// A query whose tests fit another pose.
struct PoseProblem {
    QueryName query;
    std::string pose;    ///< the pose that they fit: "the pose of the frame before"
    PoseFit told, fits;  ///< errors with the recorded pose, and with the other
    /// Only the tests of volumes fit the other pose; the tests of triangles fit the recorded one.
    bool only_volumes = false;
};

/// Looks for other poses that explain wrong tests: the engine may have mixed up its poses.
class PoseSearch {
  public:
    /// Takes a query with wrong tests. A query whose tests all have one outcome is left out.
    void take(const EngineQuery& query, const QueryName& name, const BodyState& a,
              const BodyState& b);
    /// Problems whose pose explains more than half of these queries; other poses fit by chance.
    std::vector<PoseProblem> likely() const;
    /// Whether a query fits no pose, and neither of its bodies has a recorded pose.
    bool lacks_poses() const { return not_placed_; }

  private:
    bool fits(const EngineQuery& query, const Pose& with, const QueryName& name,
              const std::string& what, bool only_volumes, const PoseFit& told);

    std::vector<PoseProblem> found_;
    std::size_t queries_ = 0;
    bool not_placed_ = false;
};

}  // namespace scb::scenes
