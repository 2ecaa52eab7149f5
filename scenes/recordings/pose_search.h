#pragma once

#include <string>
#include <vector>

#include "core/judge/query_check.h"
#include "scenes/recordings/recorded_queries.h"

namespace scb::scenes {

/// A query of a recording.
struct QueryName {
    int frame = 0;
    std::string a, b;  ///< bodies
};

/// A query whose tests fit another pose.
struct PoseProblem {
    QueryName query;
    std::string pose;    ///< whose pose they fit: "the pose of the frame before"
    PoseFit told, fits;  ///< errors with the pose that was told, and with the other
    /// Its tests of volumes fit the other pose, and those of triangles the one that was told.
    bool only_volumes = false;
};

/// Looks for poses with which tests that went wrong are right: those of an engine that has mixed up
/// its poses.
class PoseSearch {
  public:
    /// Of a query with tests that are wrong. A query whose tests all say the same is left out.
    void take(const EngineQuery& query, const QueryName& name, const BodyState& a,
              const BodyState& b);
    /// What fits in more than half of these queries: what fits only here and there fits by chance.
    std::vector<PoseProblem> likely() const;
    /// Nothing fits, and of the bodies of a query no pose was recorded.
    bool lacks_poses() const { return not_placed_; }

  private:
    bool fits(const EngineQuery& query, const Pose& with, const QueryName& name,
              const std::string& what, bool only_volumes, const PoseFit& told);

    std::vector<PoseProblem> found_;
    std::size_t queries_ = 0;
    bool not_placed_ = false;
};

}  // namespace scb::scenes
