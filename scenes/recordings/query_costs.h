#pragma once

#include <map>

#include "core/judge/tight_tests.h"
#include "scenes/recordings/tree_judge.h"

namespace scb::scenes {

/// Finds why the queries of a recording take more tests than they need.
class QueryCosts {
  public:
    /// Takes the current query of the recording.
    void take(const RecordedQueries& recording, const EngineQuery& query,
              const QueryJudgement& judged);
    /// The findings about the trees of the recording.
    std::vector<CostFinding> found(RecordedQueries& recording, const TreeJudge& trees,
                                   const std::vector<TreeJudgement>& judged) const;

  private:
    /// Valid as long as the side has this tree and version.
    struct TightOfBody {
        const EngineNodes* tree = nullptr;
        int version = -1;
        TightBoxes boxes;
    };
    const TightBoxes& tight_of(std::uint32_t body, const EngineSide& side);

    std::map<std::uint32_t, CostFinding> loose_;  ///< by tree
    std::map<std::uint32_t, TightOfBody> tight_;  ///< by body
    std::uint64_t tests_ = 0, tests_if_tight_ = 0;
};

}  // namespace scb::scenes
