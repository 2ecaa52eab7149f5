#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "scenes/recordings/test_findings.h"

namespace scb::scenes {

/// The pairs that a query reported, sorted, each once: as recorded, or as its tests of items found.
std::vector<IndexPair> reported_pairs(const EngineQuery& query);

/// Gathers the judged queries of distances of a recording: wrong answers, wrong bounds, and nodes
/// that were left out although they are near enough.
class DistanceFindings {
  public:
    /// Numbers of A and B.
    using Bodies = std::array<std::uint32_t, 2>;

    /// The certified distance of these bodies at their last distance query in an earlier frame.
    std::optional<double> before(const Bodies& bodies, int frame) const;
    /// Takes a query of distances. Wrong tests are added to `tests`.
    void take(const EngineQuery& query, const Bodies& bodies, const QueryTruth& truth,
              const QueryJudgement& judged, const QueryName& name, TestFindings& tests);

    /// How many distances were recorded as answers.
    std::uint64_t count() const { return count_; }
    const ProblemGroups& answers() const { return answers_; }
    void list_not_judged(std::vector<NotJudged>& parts) const;

  private:
    ProblemGroups answers_;
    std::uint64_t queries_ = 0, count_ = 0;
    std::array<std::uint64_t, 4> states_{};  ///< queries by AnswerState
    /// The frame and the certified distance of the last distance query.
    std::map<Bodies, std::pair<int, double>> last_;
};

}  // namespace scb::scenes
