#include "render/figures/scene_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scb::render {
namespace {

constexpr int least_bars = 5, least_bar = 3;  // their number, and their height

constexpr int title_height(int small) { return small * 3 / 2; }

/// The height below the panel's rows without which there is no chart.
int least_chart(const FigureLayout& layout, const PanelChart& chart) {
    if (chart.rows.empty() || layout.portrait) return 0;
    return layout.unit / 2 + title_height(small_size(layout.unit)) + least_bars * least_bar;
}

/// Joins each `each` rows to one; all rows have the same parts.
std::vector<std::vector<BarPart>> joined_rows(const std::vector<std::vector<BarPart>>& rows,
                                              int each) {
    std::vector<std::vector<BarPart>> joined;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i % static_cast<std::size_t>(each) == 0) {
            joined.push_back(rows[i]);
            continue;
        }
        for (std::size_t part = 0; part < rows[i].size(); ++part)
            joined.back()[part].amount += rows[i][part].amount;
    }
    return joined;
}

// Draws it below the panel's rows, or beside them if the panel is below the view.
void draw_chart(Overlay& overlay, const FigureLayout& layout, int below, const Theme& theme,
                const PanelChart& chart) {
    if (chart.rows.empty()) return;
    const int unit = layout.unit, small = small_size(unit);
    PixelRect box = {layout.panel.x, below + unit / 2, layout.panel.width,
                     layout.panel.y + layout.panel.height - below - unit / 2};
    if (layout.portrait) {
        box = layout.panel;
        box.x += layout.panel.width + unit;
        box.width = layout.view.x + layout.view.width - box.x;
    }
    const int labels = small * 5 / 3, top = box.y + title_height(small),
              height = box.y + box.height - top;
    if (height < least_bars * least_bar || box.width < 6 * unit) return;
    // Without room for so many bars, a bar is for several rows.
    const int each = (static_cast<int>(chart.rows.size()) * least_bar + height - 1) / height;
    const std::vector<std::vector<BarPart>> bars = joined_rows(chart.rows, each);
    const auto count = static_cast<int>(bars.size());
    const int bar_height = std::min(unit, height / count);
    double full = 0;
    for (const std::vector<BarPart>& row : bars) {
        double sum = 0;
        for (const BarPart& part : row) sum += part.amount;
        full = std::max(full, sum);
    }
    const TextStyle faint{small, FontWeight::regular, theme.faint_text};
    const TextStyle label{small, FontWeight::regular, theme.faint_text, Align::right};
    overlay.text(box.x, box.y,
                 chart.title + (each > 1 ? ", " + std::to_string(each) + " each" : ""), faint);
    overlay.text(box.x + box.width, box.y, "to " + count_text(static_cast<std::uint64_t>(full)),
                 label);
    // Labels as many bars as there is room for.
    const int step = bar_height >= small ? 1 : bar_height * 5 >= small ? 5 : 10;
    for (int i = 0; i < count; ++i) {
        const int y = top + i * bar_height, gap = bar_height > 3 ? 1 : 0;
        if (i % step == 0)
            overlay.text(box.x + labels - unit / 3, y + (bar_height - small) / 2,
                         std::to_string(i * each), label);
        draw_stacked_bar(overlay, {box.x + labels, y, box.width - labels, bar_height - gap},
                         bars[static_cast<std::size_t>(i)], full);
    }
}

/// A square in the lower right corner of the view.
PixelRect corner_square(const FigureLayout& layout) {
    const int size = layout.view.height / 4;
    return {layout.view.x + layout.view.width - size, layout.view.y + layout.view.height - size,
            size, size};
}

bool meet(const PixelRect& a, const PixelRect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

/// The way from the point of a label to its middle, so that the label is above its line.
ScreenPosition beside_line(const Camera& camera, const PixelRect& view, const SceneLabel& label,
                           const Vec3& at, const TextSize& size, int unit) {
    if (!label.line_end) return {};
    const Vec3 end = project(camera, *label.line_end, view.width, view.height);
    double x = end[1] - at[1], y = at[0] - end[0];
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return {0, -1.5 * unit};
    if (y > 0) x = -x, y = -y;
    x /= length, y /= length;
    const double distance =
        (std::abs(x) * size.width + std::abs(y) * size.height) / 2 + 3 * unit / 4.0;
    return {x * distance, y * distance};
}

void draw_labels(Overlay& overlay, const PixelRect& view, const SceneFigure& figure, int unit) {
    const Theme& theme = *figure.theme;
    const TextStyle style{small_size(unit), FontWeight::bold, theme.text, Align::center};
    const int pad = unit / 4;
    std::vector<PixelRect> drawn;
    for (const SceneLabel& label : figure.labels) {
        const Vec3 at = project(figure.pane.camera, label.at, view.width, view.height);
        const bool is_in_view =
            at[2] > 0 && at[0] >= 0 && at[0] <= view.width && at[1] >= 0 && at[1] <= view.height;
        if (!is_in_view) continue;
        const TextSize size = overlay.measure(label.text, style);
        const ScreenPosition aside = beside_line(figure.pane.camera, view, label, at, size, unit);
        const int x = view.x + static_cast<int>(at[0] + aside.x),
                  y = view.y + static_cast<int>(at[1] + aside.y);
        const PixelRect box{x - size.width / 2 - pad, y - size.height / 2, size.width + 2 * pad,
                            size.height};
        if (box.x < view.x || box.y < view.y || box.x + box.width > view.x + view.width ||
            box.y + box.height > view.y + view.height)
            continue;
        if (std::any_of(drawn.begin(), drawn.end(),
                        [&box](const PixelRect& other) { return meet(box, other); }))
            continue;
        drawn.push_back(box);
        overlay.rectangle(box, theme.panel);
        overlay.frame(box, label.frame, std::max(1, unit / 10));
        overlay.text(x, box.y, label.text, style);
    }
}

/// Sets the pane into the view, with its squares; with a panel also scale bar and remark.
Pane pane_in_view(SceneFigure& figure, PixelRect view, int unit, Overlay& overlay) {
    const Theme& theme = *figure.theme;
    // Bodies fill a close view, so the bar is below it.
    const bool is_close = figure.detail && figure.detail->shows_whole;
    const int below = is_close && figure.with_panel ? 9 * unit / 4 : 0;
    view.height -= below;
    if (figure.with_panel)
        draw_scale_bar(overlay, view, figure.pane.camera, figure.center, theme, unit, below);
    for (const SceneMarker& marker : figure.markers) {
        // Large enough to be found.
        const double least =
            unit / 2.0 / pixels_per_unit(figure.pane.camera, marker.center, view.height);
        if (const auto square =
                marker_of(view, figure.pane.camera, marker.center, std::max(marker.radius, least)))
            overlay.frame(*square, theme.text, std::max(2, unit / 8));
    }
    draw_labels(overlay, view, figure, unit);
    if (figure.with_panel) draw_remark(overlay, view, figure.remark, theme, unit);
    figure.pane.viewport = view;
    return std::move(figure.pane);
}

}  // namespace

Picture compose(SceneFigure figure, int width, int height, int samples, Overlay& overlay) {
    const FigureLayout layout = figure_layout(width, height, figure.with_panel);
    const Theme& theme = *figure.theme;
    Picture picture{width, height, samples, theme.background, {}};
    overlay.begin();
    int below = layout.panel.y;
    if (figure.with_panel) {
        draw_heading(overlay, layout, theme, figure.title, figure.subtitle);
        below = draw_side_panel(overlay, layout.panel, theme, layout.unit, figure.panel,
                                least_chart(layout, figure.chart));
        draw_chart(overlay, layout, below, theme, figure.chart);
    }
    picture.panes.push_back(pane_in_view(figure, layout.view, layout.unit, overlay));
    if (!figure.detail || !figure.with_panel) return picture;
    std::optional<PixelRect> square;
    if (figure.chart.rows.empty())
        square = detail_square(layout, below);
    else if (figure.detail->shows_whole)
        square = corner_square(layout);
    if (!square) return picture;
    Pane magnified = picture.panes.front();
    magnified.viewport = *square;
    magnified.camera = figure.detail->camera;
    draw_detail_frames(overlay, layout, *square, picture.panes.front().camera, *figure.detail,
                       theme);
    picture.panes.push_back(std::move(magnified));
    return picture;
}

Picture compose_view(SceneFigure figure, int width, int height, int unit, int samples,
                     Overlay& overlay) {
    Picture picture{width, height, samples, figure.theme->background, {}};
    overlay.begin();
    picture.panes.push_back(pane_in_view(figure, {0, 0, width, height}, unit, overlay));
    if (!figure.detail || !figure.detail->shows_whole || !figure.with_panel) return picture;
    const int side = std::min(width, height) / 4, margin = std::max(1, unit / 4);
    Pane whole = picture.panes.front();
    whole.viewport = {width - side - margin, margin, side, side};
    whole.camera = figure.detail->camera;
    draw_square_of_view(overlay, unit, whole.viewport, *figure.detail, *figure.theme);
    picture.panes.push_back(std::move(whole));
    return picture;
}

}  // namespace scb::render
