#include "render/plots/depth_matrix_plot.h"

#include <algorithm>

#include "render/overlay/font_face.h"
#include "render/plots/plot_axis.h"

namespace scb::render {
namespace {

constexpr int least_cell = 4, least_text = 10;

/// Powers of ten: the scale of a sequence of frames seldom changes.
PlotAxis axis_of_tests(const DepthMatrix& matrix) {
    std::uint64_t most = 1;
    for (const DepthCell& cell : matrix.cells) most = std::max(most, cell.tests);
    std::uint64_t high = 10;
    while (high < most && high < 1'000'000'000'000) high *= 10;
    PlotAxis axis{1, static_cast<double>(high), true, false, {}};
    for (std::uint64_t mark = 1; mark <= high; mark *= 10)
        axis.ticks.push_back({static_cast<double>(mark), short_count(mark)});
    return axis;
}

PlotAxis axis_of_shares() {
    return {0, 1, false, false, {{0, "0 %"}, {0.5, "50 %"}, {1, "100 %"}}};
}

double value_of(const DepthCell& cell, MatrixMeasure measure) {
    if (measure == MatrixMeasure::tests) return static_cast<double>(cell.tests);
    return static_cast<double>(cell.rejected) / static_cast<double>(cell.tests);
}

std::string text_of(const DepthCell& cell, MatrixMeasure measure) {
    if (measure == MatrixMeasure::tests) return short_count(cell.tests);
    return std::to_string((200 * cell.rejected + cell.tests) / (2 * cell.tests));
}

/// Black or white, whichever is legible on the color (luma of ITU-R BT.601).
Rgba8 text_on(Rgba8 color) {
    return 299 * color.r + 587 * color.g + 114 * color.b > 128'000 ? Rgba8{0, 0, 0}
                                                                   : Rgba8{255, 255, 255};
}

/// The positions of the cells.
struct Grid {
    PixelRect area;
    int cell_width = 1, cell_height = 1;

    PixelRect cell(std::size_t a, std::size_t b) const {
        return {area.x + static_cast<int>(a) * cell_width,
                area.y + static_cast<int>(b) * cell_height, cell_width, cell_height};
    }
};

Grid grid_in(const PixelRect& rect, const DepthMatrix& matrix, int largest) {
    const auto columns = static_cast<int>(matrix.depths_a),
               rows = static_cast<int>(matrix.depths_b);
    int width = std::clamp(rect.width / columns, 1, largest);
    int height = std::clamp(rect.height / rows, 1, largest);
    // Not too far from squares: both bodies count alike.
    width = std::min(width, std::max(1, height * 2));
    height = std::min(height, std::max(1, width * 2));
    return {{rect.x, rect.y, width * columns, height * rows}, width, height};
}

/// The largest size of text at which every cell's number fits into the cell; 0 if there is none.
int text_size_in(Overlay& overlay, const Grid& grid, const DepthMatrix& matrix,
                 MatrixMeasure measure, int largest) {
    int size = std::min(largest, grid.cell_height - 3);
    for (const DepthCell& cell : matrix.cells) {
        if (cell.tests == 0) continue;
        const std::string text = text_of(cell, measure);
        // Half a letter of room on both sides together.
        while (size >= least_text &&
               overlay.measure(text, {size, FontWeight::regular}).width + size / 2 >
                   grid.cell_width)
            --size;
    }
    return size >= least_text ? size : 0;
}

/// The step between labelled depths, such that labels take at most half of the axis.
std::size_t label_stride(int room, int cell) {
    std::size_t stride = 1;
    for (const std::size_t factor : {1u, 2u, 5u, 10u, 20u, 50u, 100u, 200u, 500u, 1000u}) {
        stride = factor;
        if (cell * static_cast<int>(factor) >= room) break;
    }
    return stride;
}

}  // namespace

std::string short_count(std::uint64_t count) {
    const char* unit = "";
    std::uint64_t scale = 1;
    for (const char* larger : {"k", "M", "G"}) {
        if (count / scale < 1000) break;
        scale *= 1000;
        unit = larger;
    }
    std::string text = std::to_string(count / scale);
    if (const std::uint64_t rest = count % scale; text.size() == 1 && rest > 0)
        text += "." + std::to_string(rest * 10 / scale);
    return text + unit;
}

PixelRect draw_depth_matrix(Overlay& overlay, const PixelRect& rect, const DepthMatrix& all,
                            MatrixMeasure measure, const FigureStyle& style) {
    if (all.cells.empty()) return {rect.x, rect.y, 0, 0};
    const Theme& theme = style.theme;
    const int unit = style.unit, small = small_size(unit), bar = unit * 3 / 4;
    const TextStyle label{small, FontWeight::regular, theme.faint_text, Align::right};
    const int left = overlay.measure("00", label).width + unit / 3, top = small + unit / 4;
    const int scale_height = unit / 2 + small * 13 / 10 + bar + small * 3 / 2;
    const PixelRect room{rect.x + left, rect.y + top, std::max(1, rect.width - left),
                         std::max(1, rect.height - top - scale_height)};

    const auto depths = static_cast<int>(std::max(all.depths_a, all.depths_b));
    const int most = std::max(1, std::min(room.width, room.height) / least_cell);
    const auto step = static_cast<std::size_t>((depths + most - 1) / most);
    const DepthMatrix matrix = coarser(all, step);
    const Grid grid = grid_in(room, matrix, 4 * unit);
    const PlotAxis axis =
        measure == MatrixMeasure::tests ? axis_of_tests(matrix) : axis_of_shares();

    const int text = text_size_in(overlay, grid, matrix, measure, small);
    const int gap = std::min(grid.cell_width, grid.cell_height) >= 8 ? 1 : 0;
    for (std::size_t b = 0; b < matrix.depths_b; ++b)
        for (std::size_t a = 0; a < matrix.depths_a; ++a) {
            const DepthCell& cell = matrix.at(a, b);
            PixelRect box = grid.cell(a, b);
            box.width -= gap;
            box.height -= gap;
            const Rgba8 color = cell.tests == 0
                                    ? mix(theme.background, theme.border, 0.25)
                                    : viridis(axis_position(axis, value_of(cell, measure)));
            overlay.rectangle(box, color);
            if (text == 0 || cell.tests == 0) continue;
            overlay.text(box.x + box.width / 2, box.y + (box.height - text) / 2,
                         text_of(cell, measure),
                         {text, FontWeight::regular, text_on(color), Align::center});
        }

    const int widest = overlay.measure(std::to_string((matrix.depths_a - 1) * step), label).width;
    TextStyle centered = label;
    centered.align = Align::center;
    const std::size_t across = label_stride(widest + unit / 3, grid.cell_width);
    for (std::size_t a = 0; a < matrix.depths_a; a += across)
        overlay.text(grid.cell(a, 0).x + grid.cell_width / 2, rect.y, std::to_string(a * step),
                     centered);
    const std::size_t down = label_stride(small, grid.cell_height);
    for (std::size_t b = 0; b < matrix.depths_b; b += down)
        overlay.text(grid.area.x - unit / 4,
                     grid.cell(0, b).y + (grid.cell_height - gap - small) / 2,
                     std::to_string(b * step), label);

    std::string title = measure == MatrixMeasure::tests ? "volume tests" : "rejected of the tests";
    if (step > 1)
        title += ", " + std::to_string(step) + " × " + std::to_string(step) + " depths per cell";
    std::vector<Tick> ticks;
    for (const AxisTick& tick : axis.ticks)
        ticks.push_back({axis_position(axis, tick.value), tick.label});
    const int wide = std::min(room.width, std::max(grid.area.width, 10 * unit));
    const PixelRect scale = draw_color_bar(
        overlay, {room.x, grid.area.y + grid.area.height + unit / 2 + small * 13 / 10, wide, bar},
        viridis, title, ticks, style);
    return {rect.x, rect.y, std::max(grid.area.width, wide) + left,
            scale.y + scale.height - rect.y};
}

}  // namespace scb::render
