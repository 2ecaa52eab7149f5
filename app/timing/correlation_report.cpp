#include "app/timing/correlation_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/statistics.h"
#include "core/base/text_format.h"

namespace scb::app {
namespace {

using Json = nlohmann::ordered_json;

struct QueryCost {
    const char* name;
    const char* title;
    double MeasuredQuery::*took;
};
constexpr std::array costs = {
    QueryCost{"n_v", "volume tests, N_v", &MeasuredQuery::n_v},
    QueryCost{"n_p", "triangle tests, N_p", &MeasuredQuery::n_p},
    QueryCost{"ms", "time", &MeasuredQuery::ms},
};

std::string counted(std::size_t count, const char* one, const char* many) {
    return format("%zu %s", count, count == 1 ? one : many);
}

std::string correlation_text(double value) {
    return std::isfinite(value) ? format("%6.2f", value) : std::string("     -");
}

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::string correlation_csv_header() {
    std::string text = "scene,hierarchy,split,n_v,n_p,ms";
    for (const CostPredictor& predictor : cost_predictors())
        text += "," + std::string(predictor.name);
    return text + "\n";
}

void BenchCorrelation::add(const SceneBench& bench) {
    MeasuredScene scene;
    std::set<std::pair<VolumeKind, SplitMethod>> known;
    for (const SubjectBench& s : bench.subjects) {
        if (s.predictors.empty() || !known.insert({s.subject.kind, s.subject.split}).second)
            continue;
        scene.push_back({s.predictors, mean(s.n_v), mean(s.n_p), s.mean_ms(),
                         static_cast<std::size_t>(s.subject.kind)});
        csv += bench.scene + "," + std::string(volume_kind_name(s.subject.kind)) + "," +
               std::string(split_method_name(s.subject.split)) +
               format(",%.17g,%.17g,%.6f", scene.back().n_v, scene.back().n_p, scene.back().ms);
        for (const double value : s.predictors) csv += format(",%.17g", value);
        csv += "\n";
    }
    names.push_back(bench.scene);
    scenes.push_back(std::move(scene));
}

std::string BenchCorrelation::table() const {
    std::string text =
        "Which measure tells the cost? Spearman's rank correlation within each scene, over " +
        counted(hierarchies(), "hierarchy", "hierarchies") + ": mean of " +
        counted(scenes.size(), "scene", "scenes") +
        " (least, most);\n"
        "pooled over all; split: how often the cheaper of two splits of one volume has the smaller "
        "measure\n" +
        format("  %-24s", "");
    for (const QueryCost& cost : costs) text += format("  %-34s", cost.title);
    text += "\n" + format("  %-24s", "measure");
    for (std::size_t i = 0; i < costs.size(); ++i)
        text += "    mean (least,  most) pooled  split  ";
    text += "\n";
    std::size_t queries = 0, pairs = 0;
    for (std::size_t p = 0; p < cost_predictors().size(); ++p) {
        text += format("  %-24s", std::string(cost_predictors()[p].title).c_str());
        for (const QueryCost& cost : costs) {
            const CostCorrelation c = cost_correlation(scenes, p, cost.took);
            text += "  " + correlation_text(c.mean) + " (" + correlation_text(c.least).substr(1) +
                    ", " + correlation_text(c.most).substr(1) + ") " + correlation_text(c.pooled) +
                    (c.split_pairs == 0 ? std::string("      -")
                                        : format("  %3.0f %%", 100 * c.split_agreement)) +
                    "  ";
            queries = c.queries;
            if (&cost == costs.data()) pairs = c.split_pairs;
        }
        text += "\n";
    }
    return text +
           format("  n = %zu: each hierarchy in each scene, by its means over the frames; ",
                  queries) +
           counted(pairs, "pair", "pairs") + " of splits\n";
}

Json BenchCorrelation::json() const {
    Json measures = Json::array();
    for (std::size_t p = 0; p < cost_predictors().size(); ++p) {
        Json row = {{"measure", cost_predictors()[p].name}};
        for (const QueryCost& cost : costs) {
            const CostCorrelation c = cost_correlation(scenes, p, cost.took);
            Json of_scene;
            for (std::size_t s = 0; s < names.size(); ++s)
                of_scene[names[s]] = number_json(c.of_scene[s]);
            row[cost.name] = {
                {"mean", number_json(c.mean)},
                {"least", number_json(c.least)},
                {"most", number_json(c.most)},
                {"pooled", number_json(c.pooled)},
                {"queries", c.queries},
                {"split_agreement", c.split_pairs == 0 ? Json() : Json(c.split_agreement)},
                {"split_pairs", c.split_pairs},
                {"scenes", std::move(of_scene)}};
        }
        measures.push_back(std::move(row));
    }
    return measures;
}

render::CorrelationFigure BenchCorrelation::figure() const {
    render::CorrelationFigure figure;
    figure.title = "Which measure tells the cost of a query?";
    figure.subtitle = counted(hierarchies(), "hierarchy", "hierarchies") + " in each of " +
                      counted(scenes.size(), "scene", "scenes");
    for (const QueryCost& cost : {costs[0], costs[2]}) {
        render::CorrelationPlot plot;
        plot.title = cost.title;
        for (std::size_t p = 0; p < cost_predictors().size(); ++p) {
            const CostCorrelation c = cost_correlation(scenes, p, cost.took);
            plot.rows.push_back({std::string(cost_predictors()[p].title), c.of_scene, c.mean});
        }
        figure.plots.push_back(std::move(plot));
    }
    // Both plots are in the order of the first one, by N_v.
    std::vector<std::size_t> order(figure.plots[0].rows.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        const auto rank = [&](std::size_t row) {
            const double mean = figure.plots[0].rows[row].mean;
            return std::isnan(mean) ? -HUGE_VAL : mean;  // a measure with one value everywhere
        };
        return rank(i) > rank(j);
    });
    for (render::CorrelationPlot& plot : figure.plots) {
        std::vector<render::CorrelationRow> rows;
        for (const std::size_t i : order) rows.push_back(plot.rows[i]);
        plot.rows = std::move(rows);
    }
    return figure;
}

}  // namespace scb::app
