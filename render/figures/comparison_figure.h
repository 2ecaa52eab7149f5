#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/overlay/figure_layout.h"
#include "render/overlay/side_panel.h"

namespace scb::render {

/// One of two compared things.
struct ComparedView {
    std::string caption;             ///< above the view
    Pane pane;                       ///< its viewport is set by compose()
    std::vector<PanelItem> numbers;  ///< below the view
    std::vector<PanelItem> legend;   ///< beside the numbers, or below if there is no room
    std::string remark;              ///< in the view, at the top
    /// The number of outlined things, see outline_differences; nothing if the views cannot be
    /// compared.
    std::optional<std::size_t> outlined{};
};

/// A picture with two views of one scene, by one camera on one scale, and the numbers of each below
/// it.
struct ComparisonFigure {
    std::string title;
    std::string subtitle;
    std::array<ComparedView, 2> views;
    Vec3 center = Vec3::Zero();  ///< the place for which the scale bar is valid
    const Theme* theme = &light_theme;
};

/// Lines of text below a view.
struct ComparisonRows {
    int numbers = 0;
    int legend = 0;
};

/// The positions of the parts of such a picture: the views side by side, or below each other if the
/// picture is taller than wide.
struct ComparisonLayout {
    struct Side {
        PixelRect caption, view, numbers, legend;
    };

    int unit = 20;  ///< size of body text, pixels
    PixelRect heading;
    std::array<Side, 2> sides;
};
ComparisonLayout comparison_layout(int width, int height, ComparisonRows rows);

/// Outlines in both views the things that differ, among things with this id or a larger one.
/// Returns the number of these things, visible or not.
std::size_t outline_differences(std::array<ComparedView, 2>& views, std::uint32_t first_id,
                                const Theme& theme);

/// The views' cameras must be for the aspect of the views of comparison_layout.
Picture compose(ComparisonFigure figure, const ComparisonLayout& layout, int width, int height,
                int samples, Overlay& overlay);

}  // namespace scb::render
