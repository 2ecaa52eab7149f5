#include "render/figures/correlation_figure.h"

#include <limits>

#include "render/overlay/figure_layout.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

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
    Drawing drawing;
    CorrelationFigure wide = measures_example();
    for (CorrelationPlot& plot : wide.plots)
        for (CorrelationRow& row : plot.rows) row.name = std::string(80, 'W');
    for (const CorrelationFigure& figure : {measures_example(), wide, CorrelationFigure{}})
        for (const Theme* theme : {&light_theme, &dark_theme})
            for (const auto& [width, height] :
                 {std::pair{1280, 720}, {640, 480}, {400, 800}, {320, 240}, {64, 48}}) {
                CorrelationFigure themed = figure;
                themed.theme = theme;
                Overlay overlay;
                const Picture picture = compose(themed, width, height, overlay);
                const Image image = drawing.renderer.draw(picture, &overlay).image;
                const int margin = figure_layout(width, height).heading.x - 1;
                const auto [inside, outside] = inside_and_outside(
                    image, {margin, margin, width - 2 * margin, height - 2 * margin},
                    theme->background);
                EXPECT_EQ(outside, 0) << width << "x" << height;
            }
}

}  // namespace
}  // namespace scb::render
