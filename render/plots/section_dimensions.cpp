#include "render/plots/section_dimensions.h"

#include <algorithm>
#include <array>

#include "render/overlay/figure_layout.h"
#include "render/overlay/smooth_line.h"

namespace scb::render {
namespace {

/// Labels one below the other, each as near to its height as the others let it.
std::vector<int> spread(std::vector<double> heights, int line, int top, int bottom) {
    std::vector<int> ys;
    int free = top;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        ys.push_back(std::max(free, static_cast<int>(std::lround(heights[i])) - line / 2));
        free = ys.back() + line;
    }
    int below = bottom;
    for (std::size_t i = ys.size(); i-- > 0;) {
        ys[i] = std::min(ys[i], below - line);
        below = ys[i];
    }
    return ys;
}

int column_step(int unit) { return unit * 3 / 5; }

}  // namespace

std::string length_text(const std::string& name, double value) {
    return name + " = " + (value < 0 ? "−" : "") + number_text(std::abs(value));
}

int dimensions_width(Overlay& overlay, const std::vector<SectionDimension>& all, int unit) {
    int widest = 0;
    for (const SectionDimension& d : all)
        widest = std::max(widest,
                          overlay.measure(d.label, {small_size(unit), FontWeight::bold, {}}).width);
    return widest + section_dimension_columns * column_step(unit) + unit / 2 + small_size(unit);
}

void draw_dimensions(Overlay& overlay, const SectionScale& scale, const PixelRect& box,
                     std::vector<SectionDimension> all, const Theme& theme, int unit,
                     double line_width) {
    const int top = scale.rect.y, bottom = top + scale.rect.height;
    const auto clamped = [&](double y) {
        return std::clamp(scale.py(y), double(top), double(bottom));
    };
    const int label_x = box.x + section_dimension_columns * column_step(unit) + unit / 2;
    for (const SectionDimension& d : all) {
        const double x = box.x + (d.column + 0.5) * column_step(unit), from = clamped(d.from),
                     to = clamped(d.to), tick = unit / 5.0,
                     width = d.strong ? 2 * line_width : line_width;
        draw_smooth_line(overlay, std::array{ScreenPosition{x, from}, ScreenPosition{x, to}},
                         d.color, width);
        for (const double y : {d.from, d.to})
            if (scale.shows_height(y))
                draw_smooth_line(overlay,
                                 std::array{ScreenPosition{x - tick, scale.py(y)},
                                            ScreenPosition{x + tick, scale.py(y)}},
                                 d.color, line_width);
    }
    std::erase_if(all, [](const SectionDimension& d) { return d.label.empty(); });
    const auto height = [&](const SectionDimension& d) {
        return (clamped(d.from) + clamped(d.to)) / 2;
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const SectionDimension& p, const SectionDimension& q) {
                         return height(p) < height(q);
                     });
    const int small = small_size(unit), line = small * 5 / 4;
    std::vector<double> heights;
    for (const SectionDimension& d : all) heights.push_back(height(d));
    const std::vector<int> ys = spread(heights, line, top, bottom);
    for (std::size_t i = 0; i < all.size(); ++i) {
        overlay.rectangle({label_x, ys[i] + small / 2 - small / 4, small / 2, small / 2},
                          all[i].color);
        const TextStyle style{small, all[i].strong ? FontWeight::bold : FontWeight::regular,
                              theme.text};
        overlay.text(label_x + small * 3 / 4, ys[i], all[i].label, style);
    }
}

}  // namespace scb::render
