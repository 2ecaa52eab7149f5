#include "render/plots/length_histogram.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/portable_math.h"
#include "render/overlay/figure_layout.h"

namespace scb::render {
namespace {

int bin_of(double share) {
    if (!(share > 0)) return LengthHistogram::bins;
    if (!std::isfinite(share)) return 0;  // if the roots have no size
    const double place = std::floor(-LengthHistogram::per_halving * binary_logarithm(share));
    return static_cast<int>(std::clamp(place, 0.0, 1.0 * LengthHistogram::bins));
}

int row_height(const FigureStyle& style) { return style.unit * 7 / 4; }

}  // namespace

void LengthHistogram::add(double diameter, double thickness) {
    // A thickness of rounding noise counts as 0.
    const double tau = thickness < 1e-12 * diameter ? 0 : thickness;
    ++diameters[static_cast<std::size_t>(bin_of(diameter / root_diameter))];
    ++thicknesses[static_cast<std::size_t>(bin_of(tau / root_diameter))];
    differ |= tau != diameter;
}

int length_histogram_height(const FigureStyle& style) {
    return small_size(style.unit) * 5 / 4 * 2 + 2 * row_height(style) + style.unit / 2;
}

PixelRect draw_length_histogram(Overlay& overlay, const PixelRect& rect,
                                const LengthHistogram& histogram, const FigureStyle& style) {
    const int unit = style.unit, small = small_size(unit), line = small * 5 / 4;
    const TextStyle faint{small, FontWeight::regular, style.theme.faint_text};
    const TextStyle right{small, FontWeight::regular, style.theme.faint_text, Align::right};
    const TextStyle middle{small, FontWeight::regular, style.theme.faint_text, Align::center};
    const TextStyle name{small, FontWeight::medium, style.theme.text};
    const int names = unit * 5 / 4;
    // The smallest lengths stand apart, since their bin has no lower end.
    const int columns = LengthHistogram::bins + 2;
    const int bin = (rect.width - names) / columns;
    if (bin < 3 || rect.height < length_histogram_height(style)) return {rect.x, rect.y, 0, 0};
    const int left = rect.x + names, end = left + bin * columns;
    const auto x_of = [&](int i) {
        return i == LengthHistogram::bins ? left : end - (i + 1) * bin;
    };

    overlay.text(rect.x, rect.y, "volumes by length", faint);
    int y = rect.y + line;
    using Row = std::pair<const char*, const LengthHistogram::Counts*>;
    for (const auto& [label, counts] :
         {Row{"d", &histogram.diameters}, Row{"τ", &histogram.thicknesses}}) {
        if (counts == &histogram.thicknesses && !histogram.differ) break;
        const std::uint32_t most = std::max(1u, *std::max_element(counts->begin(), counts->end()));
        const int full = row_height(style) - unit / 4, base = y + row_height(style);
        for (int i = 0; i <= LengthHistogram::bins; ++i) {
            const std::uint32_t count = (*counts)[static_cast<std::size_t>(i)];
            if (count == 0) continue;
            // Every nonempty bin is visible.
            const int height = std::max(
                1, static_cast<int>(std::lround(static_cast<double>(count) / most * full)));
            overlay.rectangle({x_of(i), base - height, bin - 1, height}, style.theme.faint_text);
        }
        overlay.rectangle({left, base, end - left, 1}, style.theme.border);
        overlay.text(rect.x, base - small, label, name);
        y = base;
    }
    y += unit / 4;
    const auto tick = [&](int from_right, const std::string& text, const TextStyle& text_style) {
        const int x = end - from_right * LengthHistogram::per_halving * bin;
        overlay.rectangle({x, y - unit / 4, 1, unit / 4}, style.theme.faint_text);
        overlay.text(x, y, text, text_style);
    };
    overlay.text(left, y, "less", faint);
    tick(0, "root's d", right);
    for (const int halving : {5, 10}) tick(halving, "1/" + std::to_string(1 << halving), middle);
    return {rect.x, rect.y, end - rect.x, y + line - rect.y};
}

}  // namespace scb::render
