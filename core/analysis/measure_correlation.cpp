#include "core/analysis/measure_correlation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/statistics.h"

namespace scb {
namespace {

double hull_of(const HierarchyMeasures& m) { return m.levels.front().hull_volume; }

constexpr std::array predictors = {
    CostPredictor{"sah_cost", "SAH cost",
                  [](const HierarchyMeasures& m) { return m.all.sah_cost; }},
    CostPredictor{"area", "summed area",
                  [](const HierarchyMeasures& m) { return ratio(m.all.area, m.surface); }},
    CostPredictor{"volume", "summed volume",
                  [](const HierarchyMeasures& m) { return ratio(m.all.volume, hull_of(m)); }},
    CostPredictor{"sibling_overlap", "sibling overlap, mean",
                  [](const HierarchyMeasures& m) { return m.all.sibling_overlap; }},
    CostPredictor{
        "overlap_volume", "sibling overlap, summed",
        [](const HierarchyMeasures& m) { return ratio(m.all.overlap_volume, hull_of(m)); }},
    CostPredictor{"epo", "EPO", [](const HierarchyMeasures& m) { return m.all.epo; }},
    CostPredictor{"leaf_count", "leaf count, mean",
                  [](const HierarchyMeasures& m) { return m.leaf_count; }},
    CostPredictor{"lcv", "LCV", [](const HierarchyMeasures& m) { return m.lcv; }},
    CostPredictor{"looseness", "looseness",
                  [](const HierarchyMeasures& m) { return 1 - m.all.tightness; }},
};

}  // namespace

std::span<const CostPredictor> cost_predictors() { return predictors; }

CostCorrelation cost_correlation(std::span<const MeasuredScene> scenes, std::size_t predictor,
                                 double MeasuredQuery::*took) {
    CostCorrelation result;
    std::vector<double> all_measures, all_costs, known;
    double agreeing = 0;
    for (const MeasuredScene& scene : scenes) {
        std::vector<double> measures, costs;
        for (const MeasuredQuery& query : scene) {
            measures.push_back(query.predictors[predictor]);
            costs.push_back(query.*took);
        }
        result.of_scene.push_back(rank_correlation(measures, costs));
        if (std::isfinite(result.of_scene.back())) known.push_back(result.of_scene.back());
        for (std::size_t i = 0; i < scene.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                if (scene[i].volume != scene[j].volume || costs[i] == costs[j]) continue;
                ++result.split_pairs;
                if (measures[i] == measures[j])
                    agreeing += 0.5;
                else if ((measures[i] < measures[j]) == (costs[i] < costs[j]))
                    agreeing += 1;
            }
        all_measures.insert(all_measures.end(), measures.begin(), measures.end());
        all_costs.insert(all_costs.end(), costs.begin(), costs.end());
    }
    result.queries = all_costs.size();
    result.mean = mean(known);
    result.least = known.empty() ? result.mean : *std::min_element(known.begin(), known.end());
    result.most = known.empty() ? result.mean : *std::max_element(known.begin(), known.end());
    result.pooled = rank_correlation(all_measures, all_costs);
    result.split_agreement = ratio(agreeing, static_cast<double>(result.split_pairs));
    return result;
}

}  // namespace scb
