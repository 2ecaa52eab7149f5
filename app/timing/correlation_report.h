#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/study/bench_run.h"
#include "core/analysis/measure_correlation.h"
#include "render/figures/correlation_figure.h"

namespace scb::app {

/// The correlation between measures of hierarchies and the costs of their queries, over the scenes
/// of a run. Only reference hierarchies count, and of these the first of each volume and split.
struct BenchCorrelation {
    std::vector<std::string> names;  ///< of scenes
    std::vector<MeasuredScene> scenes;
    std::string csv;  ///< a line per scene and hierarchy, see correlation_csv_header

    void add(const SceneBench& bench);
    std::size_t hierarchies() const { return scenes.empty() ? 0 : scenes[0].size(); }
    std::string table() const;
    nlohmann::ordered_json json() const;
    render::CorrelationFigure figure() const;
};

/// "scene,hierarchy,split,n_v,n_p,ms" and the predictors.
std::string correlation_csv_header();

}  // namespace scb::app
