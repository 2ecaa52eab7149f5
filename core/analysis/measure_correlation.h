#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/analysis/hierarchy_measures.h"

namespace scb {

/// A measure of hierarchies that may tell what a query of them costs: a number without unit, so
/// that a large mesh does not outweigh a small one.
struct CostPredictor {
    std::string_view name;   ///< in JSON and CSV
    std::string_view title;  ///< in tables and figures
    double (*of)(const HierarchyMeasures&);
};

/// SAH cost, area over that of the mesh, volume over that of its hull, overlap of siblings (mean,
/// and summed over the volume of the hull), EPO, how many leaves a line meets, LCV, looseness (1 -
/// tightness): all of which promise a cheap query where they are small.
std::span<const CostPredictor> cost_predictors();

/// Hierarchies of both bodies of a scene, as they were measured, and what queries of them took.
struct MeasuredQuery {
    std::vector<double> predictors;  ///< per CostPredictor, the mean of both bodies
    double n_v = 0, n_p = 0, ms = 0;
    std::size_t volume = 0;  ///< those of one scene that have the same differ in their split alone
};

/// The queries of one scene; a correlation within it is of hierarchies of the same meshes.
using MeasuredScene = std::vector<MeasuredQuery>;

/// How a measure goes together with what queries took. Ranks are taken within each scene, since
/// scenes differ in how close the bodies come, which no measure of a hierarchy can know.
struct CostCorrelation {
    std::vector<double> of_scene;  ///< Spearman's, NaN where a scene does not vary
    double mean = 0;               ///< of those that are no NaN
    double least = 0, most = 0;
    double pooled = 0;  ///< Spearman's over all queries of all scenes together
    std::size_t queries = 0;
    /// Of the pairs of queries that differ in the split alone and in what they took, the share in
    /// which the cheaper one has the smaller measure; equal measures count half.
    double split_agreement = 0;
    std::size_t split_pairs = 0;
};

/// `took` is what the measure is to predict, such as &MeasuredQuery::n_v. All queries must have as
/// many predictors.
CostCorrelation cost_correlation(std::span<const MeasuredScene> scenes, std::size_t predictor,
                                 double MeasuredQuery::*took);

}  // namespace scb
