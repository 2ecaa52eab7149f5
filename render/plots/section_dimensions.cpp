#include "render/plots/section_dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text_format.h"
#include "render/overlay/figure_layout.h"
#include "render/overlay/line_stroke.h"

namespace scb::render {
namespace {

constexpr int most_decimals = 15;

double power_of_ten(int exponent) {
    double power = 1;
    for (int i = 0; i < exponent; ++i) power *= 10;
    return power;
}

/// The number of decimals that show three digits.
int decimals_of(double value) {
    int decimals = 0;
    while (decimals < most_decimals && value * power_of_ten(decimals) < 100) ++decimals;
    return decimals;
}

int decimals_of(const std::vector<double>& numbers, double largest) {
    if (!(largest > 0)) return 0;
    int decimals = decimals_of(largest);
    // Less than a hundred thousandth is rounding, or invisible in a sum.
    for (const double v : numbers)
        if (std::abs(v) > 1e-5 * largest) decimals = std::max(decimals, decimals_of(std::abs(v)));
    return decimals;
}

std::string decimal_text(double value, int decimals) {
    if (decimals == 0) return count_text(static_cast<std::uint64_t>(std::llround(value)));
    return format("%.*f", decimals, value);
}

int column_step(int unit) { return unit * 3 / 5; }

struct Table {
    std::vector<std::string> numbers;
    int names = 0, width = 0;

    Table(Overlay& overlay, const std::vector<SectionDimension>& all, int unit) {
        std::vector<double> values;
        for (const SectionDimension& d : all) values.push_back(d.value);
        numbers = sum_texts(values);
        const TextStyle bold{small_size(unit), FontWeight::bold, {}};
        int widest = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            names = std::max(names, overlay.measure(all[i].name, bold).width);
            widest = std::max(widest, overlay.measure(numbers[i], bold).width);
        }
        names += small_size(unit);
        width = names + unit / 2 + widest;
    }
};

}  // namespace

std::vector<std::string> sum_texts(const std::vector<double>& numbers) {
    double largest = 0;
    for (const double v : numbers) largest = std::max(largest, std::abs(v));
    // Beyond this range, decimals do not suit.
    if (largest > 0 && (largest < 1e-6 || largest >= 1e12)) {
        std::vector<std::string> texts;
        for (const double v : numbers)
            texts.push_back((v < 0 ? "−" : "") + number_text(std::abs(v)));
        return texts;
    }
    const std::size_t terms = numbers.size() - 1;
    double scale = 1, missing = 0;
    std::vector<double> rounded;
    const auto round_all = [&](int decimals) {
        scale = power_of_ten(decimals);
        rounded.clear();
        for (const double v : numbers) rounded.push_back(std::round(v * scale));
        missing = rounded[terms];
        for (std::size_t i = 0; i < terms; ++i) missing -= rounded[i];
        return missing == 0;
    };
    // One or two more digits may suffice.
    const int least = decimals_of(numbers, largest);
    int decimals = least;
    while (!round_all(decimals) && decimals < least + 2) ++decimals;
    if (missing != 0) round_all(decimals = least);
    // The rounding error of the sum is added to the terms that rounding changed most.
    for (std::size_t count = 0; std::abs(missing) > 0.5 && count < terms; ++count) {
        const double step = missing > 0 ? 1 : -1;
        std::size_t most = 0;
        const auto lost = [&](std::size_t i) { return step * (numbers[i] * scale - rounded[i]); };
        for (std::size_t i = 1; i < terms; ++i)
            if (lost(i) > lost(most)) most = i;
        rounded[most] += step;
        missing -= step;
    }
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double v = rounded[i];
        texts.push_back(v == 0 ? "0"
                               : (v < 0        ? "−"
                                  : i == terms ? "+"
                                               : "") +
                                     decimal_text(std::abs(v) / scale, decimals));
    }
    return texts;
}

int dimensions_width(Overlay& overlay, const std::vector<SectionDimension>& all, int unit) {
    return static_cast<int>(all.size()) * column_step(unit) + unit / 2 +
           Table(overlay, all, unit).width;
}

void draw_dimensions(Overlay& overlay, const SectionScale& scale, const PixelRect& box,
                     const std::vector<SectionDimension>& all, const Theme& theme, int unit,
                     double line_width) {
    const int top = scale.rect.y, bottom = top + scale.rect.height;
    const auto clamped = [&](double y) {
        return std::clamp(scale.py(y), double(top), double(bottom));
    };
    const int small = small_size(unit), line = small * 5 / 4, count = static_cast<int>(all.size()),
              x = box.x + count * column_step(unit) + unit / 2;
    const Table table(overlay, all, unit);
    int y = std::max(box.y, box.y + (box.height - count * line) / 2);
    for (int i = 0; i < count; ++i) {
        const SectionDimension& d = all[static_cast<std::size_t>(i)];
        const std::string& number = table.numbers[static_cast<std::size_t>(i)];
        const double column = box.x + (i + 0.5) * column_step(unit), tick = unit / 5.0,
                     width = d.strong ? 2 * line_width : line_width;
        if (number != "0") {
            draw_smooth_line(overlay,
                             std::array{ScreenPosition{column, clamped(d.from)},
                                        ScreenPosition{column, clamped(d.to)}},
                             d.color, width);
            for (const double end : {d.from, d.to})
                if (scale.shows_height(end))
                    draw_smooth_line(overlay,
                                     std::array{ScreenPosition{column - tick, scale.py(end)},
                                                ScreenPosition{column + tick, scale.py(end)}},
                                     d.color, line_width);
        }
        if (y + small > box.y + box.height) continue;
        if (i + 1 == count) overlay.rectangle({x, y - line / 8, table.width, 1}, theme.text);
        // Drawn like the length itself.
        const int sample = static_cast<int>(std::lround(width));
        overlay.rectangle(
            {x + small / 4 - sample / 2, y + small / 8, std::max(1, sample), small * 3 / 4},
            d.color);
        TextStyle style{small, i + 1 == count ? FontWeight::bold : FontWeight::regular, theme.text};
        overlay.text(x + small * 3 / 4, y, d.name, style);
        style.align = Align::right;
        overlay.text(x + table.width, y, number, style);
        y += line;
    }
}

}  // namespace scb::render
