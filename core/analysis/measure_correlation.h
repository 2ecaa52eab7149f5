#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/analysis/hierarchy_measures.h"

namespace scb {

/// A measure of hierarchies that may predict the cost of a query. It has no unit, so that a large
/// mesh does not outweigh a small one.
struct CostPredictor {
    std::string_view name;   ///< in JSON and CSV
    std::string_view title;  ///< in tables and figures
    double (*of)(const HierarchyMeasures&);
};

/// SAH cost, area over the mesh's area, volume over the volume of the mesh's hull, overlap of
/// siblings (mean, and sum over the volume of the hull), EPO, number of leaves that a line meets,
/// LCV, looseness (1 - tightness). Small values promise a cheap query.
std::span<const CostPredictor> cost_predictors();

/// Measures of the hierarchies of both bodies of a scene, and the costs of their query.
struct MeasuredQuery {
    std::vector<double> predictors;  ///< per CostPredictor, the mean of both bodies
    double n_v = 0, n_p = 0, ms = 0;
    std::size_t volume = 0;  ///< queries of one scene with the same volume differ only in the split
};

/// The queries of one scene, with hierarchies of the same meshes.
using MeasuredScene = std::vector<MeasuredQuery>;

/// The correlation of a measure with the costs of queries. Ranks are taken within each scene, since
/// scenes differ in how close the bodies come, which no measure of a hierarchy can know.
struct CostCorrelation {
    std::vector<double> of_scene;  ///< Spearman's; NaN if a scene does not vary
    double mean = 0;               ///< of the correlations that are not NaN
    double least = 0, most = 0;
    double pooled = 0;  ///< Spearman's over all queries of all scenes together
    std::size_t queries = 0;
    /// Among pairs of queries that differ in cost, and otherwise only in the split: the share in
    /// which the cheaper query has the smaller measure. Equal measures count half.
    double split_agreement = 0;
    std::size_t split_pairs = 0;
};

/// `took`: the cost to predict, such as &MeasuredQuery::n_v. All queries must have the same number
/// of predictors.
CostCorrelation cost_correlation(std::span<const MeasuredScene> scenes, std::size_t predictor,
                                 double MeasuredQuery::*took);

}  // namespace scb
