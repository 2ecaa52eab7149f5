#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/study/bench_run.h"
#include "core/analysis/cost_equation.h"
#include "render/figures/bench_figure.h"

namespace scb::app {

/// One row per hierarchy: mean time, N_v, N_p and pairs per frame; its time as a multiple of the
/// time of the first slab cut ball hierarchy; and Table 3's figures.
std::string bench_table(const SceneBench& bench);

/// Equation 1 of the paper, fitted for each hierarchy over the queries of several scenes.
struct BenchCosts {
    std::vector<std::string> titles;
    std::vector<std::vector<CostSample>> samples;  ///< per title; times in ns
    std::size_t scenes = 0;

    void add(const SceneBench& bench);
    std::string table() const;
    nlohmann::ordered_json json() const;
};

/// The same as JSON, without the frames.
nlohmann::ordered_json bench_json(const SceneBench& bench);

/// The measurements of the i-th frame, for the file of a shard.
nlohmann::ordered_json bench_frame_json(const SceneBench& bench, std::size_t i);
/// Adds the measurements of a frame to the bench, which has its subjects. Throws the JSON library's
/// exceptions for JSON of another bench.
void add_bench_frame(SceneBench& bench, const nlohmann::ordered_json& json);

/// The tolerance, or the order and limits, of queries of distances.
nlohmann::ordered_json asked_json(const DistanceQuery& query);

/// Lines of the columns in bench_csv_header; without the header.
std::string bench_csv(const SceneBench& bench);
std::string bench_csv_header(const std::optional<DistanceQuery>& query);

/// Figure 11 for the scene.
render::BenchFigure bench_figure(const SceneBench& bench);

}  // namespace scb::app
