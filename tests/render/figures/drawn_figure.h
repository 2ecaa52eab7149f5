#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

#include "render/overlay/figure_layout.h"
#include "render/overlay/overlay.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {

template <class Figure>
Image drawn(Drawing& drawing, const Figure& figure, int width, int height) {
    Overlay overlay;
    const Picture picture = compose(figure, width, height, overlay);
    return drawing.renderer.draw(picture, &overlay).image;
}

/// Draws each figure in both themes and several sizes, and expects no pixel in the margins.
template <class Figure>
void expect_free_margins(std::initializer_list<Figure> figures) {
    Drawing drawing;
    for (Figure figure : figures)
        for (const Theme* theme : {&light_theme, &dark_theme})
            for (const auto& [width, height] :
                 {std::pair{1280, 720}, {640, 480}, {400, 800}, {320, 240}, {64, 48}}) {
                figure.theme = theme;
                const int margin = figure_layout(width, height).heading.x - 1;
                const auto [inside, outside] = inside_and_outside(
                    drawn(drawing, figure, width, height),
                    {margin, margin, width - 2 * margin, height - 2 * margin}, theme->background);
                EXPECT_EQ(outside, 0) << width << "x" << height;
            }
}

}  // namespace scb::render
