#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenes/recordings/judgement_words.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::scenes {

using ProblemGroups = std::vector<ProblemGroup>;

/// Counts the case in the group of this name.
void add_case(ProblemGroups& groups, const std::string& what, ProblemCase one);

/// Whether nodes of A and B with these numbers exist and have volumes.
bool have_volumes(const EngineQuery& query, IndexPair numbers);

/// Sorts the groups, the most frequent first.
ProblemGroups by_count(ProblemGroups groups);

/// Gathers the judged tests of all queries: by stage, and the wrong ones.
class TestFindings {
  public:
    /// `recording` must be at this query; `row` is the row of its frame.
    void take(const RecordedQueries& recording, const EngineQuery& query,
              const QueryJudgement& judged, const QueryName& name, FrameJudgement& row);
    /// Adds another problem.
    void add(const std::string& what, ProblemCase one) {
        add_case(problems_, what, std::move(one));
    }

    const ProblemGroups& problems() const { return problems_; }
    std::uint64_t unjudged() const { return unjudged_; }
    /// The stages that occur, or have a name.
    std::vector<StageJudgement> stages(const StageNames& names) const;
    /// Tests that repeat an earlier one of their query.
    std::optional<CostFinding> repeated() const;
    void list_not_judged(std::vector<NotJudged>& parts) const;

  private:
    void take_volumes(const RecordedQueries& recording, const EngineQuery& query,
                      const QueryJudgement& judged, std::uint32_t number, const QueryName& name,
                      FrameJudgement& row);
    void take_items(const EngineQuery& query, const WrongItemTest& test, const QueryName& name);
    void take_divisions(const EngineQuery& query, const QueryJudgement& judged,
                        const QueryName& name);

    std::map<std::uint8_t, StageJudgement> stages_;
    ProblemGroups problems_;
    std::uint64_t tests_ = 0, unjudged_ = 0, repeated_ = 0;
    std::size_t searches_ = 0;  ///< for sharper depths of wrong tests
    std::string first_repeated_;
    std::uint64_t divided_ = 0, lacks_ = 0;  ///< see DivisionCounts
    DivisionCounts::Lack first_lack_;
    std::string lacking_;  ///< the first such division, a clause
    bool lacks_alike_ = true;
};

}  // namespace scb::scenes
