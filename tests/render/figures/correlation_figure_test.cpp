#include "render/figures/correlation_figure.h"

#include <limits>

#include "tests/render/figures/drawn_figure.h"

namespace scb::render {
namespace {

CorrelationFigure measures_example() {
    CorrelationFigure figure;
    figure.title = "Which measure tells the cost of a query?";
    figure.subtitle = "14 hierarchies in each of 3 scenes";
    figure.footnote = std::string(200, 'W') + " " + std::string(50, 'W');
    for (const char* title : {"volume tests, N_v", "time"}) {
        CorrelationPlot plot{title, {}};
        for (int i = 0; i < 9; ++i)
            plot.rows.push_back({"measure " + std::to_string(i),
                                 {1, 0.2, -0.7, std::numeric_limits<double>::quiet_NaN()},
                                 i == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.5 / i});
        figure.plots.push_back(plot);
    }
    return figure;
}

TEST(CorrelationFigure, StaysWithinItsMargins) {
    CorrelationFigure wide = measures_example();
    for (CorrelationPlot& plot : wide.plots)
        for (CorrelationRow& row : plot.rows) row.name = std::string(80, 'W');
    expect_free_margins({measures_example(), wide, CorrelationFigure{}});
}

}  // namespace
}  // namespace scb::render
