#include "scenes/recordings/query_costs.h"

#include <array>

#include "scenes/recordings/judgement_words.h"

namespace scb::scenes {

void QueryCosts::take(const RecordedQueries& recording, const EngineQuery& query,
                      const QueryJudgement& judged) {
    if (judged.tests.empty()) return;
    const auto bodies = recording.query_bodies();
    bool any = false;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::uint32_t number = recording.bodies().at(bodies[side]).tree;
        const TightBoxes& tight = tight_of(bodies[side], query.sides[side]);
        if (tight.boxes < 8 || 4 * tight.loose < tight.boxes) continue;
        any = true;
        const auto [known, added] = loose_.try_emplace(number);
        if (added)
            known->second.where =
                tree_words(recording, number) + " since frame " + std::to_string(recording.frame());
        if (tight.loose > known->second.count)
            known->second = {CostFinding::Kind::loose, tight.loose, tight.boxes,
                             known->second.where,      0,           0};
    }
    tests_ += judged.tests.size();
    tests_if_tight_ +=
        any ? tests_with(query, judged.tests, tight_[bodies[0]].boxes, tight_[bodies[1]].boxes)
            : judged.tests.size();
}

const TightBoxes& QueryCosts::tight_of(std::uint32_t body, const EngineSide& side) {
    TightOfBody& known = tight_[body];
    if (known.tree != side.tree || known.version != side.version)
        known = {side.tree, side.version, tight_boxes(side)};
    return known.boxes;
}

std::vector<CostFinding> QueryCosts::found(RecordedQueries& recording, const TreeJudge& trees,
                                           const std::vector<TreeJudgement>& judged) const {
    std::vector<CostFinding> costs;
    for (const TreeJudgement& tree : judged) {
        const EngineSide side = recording.side_of(tree.number);
        std::uint64_t leaves = 0;
        for (const std::uint32_t node : side.shape->order) leaves += side.shape->is_leaf(node);
        std::uint64_t enough = 0;
        while ((std::uint64_t{1} << enough) < leaves) ++enough;
        if (leaves >= 16 && tree.depth > 4 * enough)
            costs.push_back({CostFinding::Kind::deep, tree.depth, enough,
                             tree_words(recording, tree.number), 0, 0});
    }
    for (auto [number, finding] : loose_) {
        finding.tests = tests_;
        finding.tests_if_tight = tests_if_tight_;
        // If a tree does not contain its triangles, loose boxes are the lesser problem.
        const bool is_wrong = trees.watches().at(number).most_outside() > 0;
        if (!is_wrong && 50 * finding.tests_if_tight < 49 * finding.tests) costs.push_back(finding);
    }
    return costs;
}

}  // namespace scb::scenes
