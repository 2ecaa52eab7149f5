#include "render/volume_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/figure_layout.h"

namespace scb {
namespace {

constexpr std::array<std::string_view, 4> names = {"body", "depth", "radius", "thickness"};

// Lighter or darker by up to a tenth, the same for a node in every picture.
Rgba8 varied(Rgba8 colour, std::uint32_t node) {
    const double t = static_cast<double>((node * 2654435761u) >> 16) / 65535.0 * 2 - 1;
    return t > 0 ? mix(colour, {255, 255, 255}, 0.16 * t) : mix(colour, {0, 0, 0}, -0.12 * t);
}

}  // namespace

std::string_view colour_by_name(ColourBy by) { return names[static_cast<std::size_t>(by)]; }

std::optional<ColourBy> colour_by_of(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<ColourBy>(i);
    return std::nullopt;
}

template <Volume V>
double colour_magnitude(const ColourScale& scale, const V& volume, int depth) {
    const double d = diameter(volume);
    switch (scale.by) {
        case ColourBy::depth:
            return scale.deepest == 0 ? 0 : static_cast<double>(depth) / scale.deepest;
        case ColourBy::radius:
            return d > 0 ? std::clamp(1 + std::log2(d / scale.root_diameter) / radius_halvings, 0.0,
                                      1.0)
                         : 0;
        // Most volumes of a deep level are nearly flat: the square root parts them.
        case ColourBy::thickness:
            return d > 0 ? std::sqrt(thickness(volume) / d) : 0;
        case ColourBy::body:
            break;
    }
    return 0;
}

template <Volume V>
Rgba8 volume_colour(const ColourScale& scale, const V& volume, int depth, std::size_t body,
                    std::uint32_t node) {
    if (scale.by == ColourBy::body) return varied(category_colour(body), node);
    return viridis(colour_magnitude(scale, volume, depth));
}

std::optional<PanelScale> legend_of(const ColourScale& scale) {
    switch (scale.by) {
        case ColourBy::depth: {
            PanelScale legend{"colour: level", {}};
            const int step = scale.deepest <= 6 ? 1 : (scale.deepest + 5) / 6;
            for (int level = 0; level <= scale.deepest; level += step)
                legend.ticks.emplace_back(
                    scale.deepest == 0 ? 0 : static_cast<double>(level) / scale.deepest,
                    std::to_string(level));
            return legend;
        }
        case ColourBy::radius: {
            PanelScale legend{"colour: d (1 = " + number_text(scale.root_diameter) + ")", {}};
            for (int halvings = radius_halvings; halvings >= 0; halvings -= 3)
                legend.ticks.emplace_back(
                    1 - static_cast<double>(halvings) / radius_halvings,
                    halvings == 0 ? "1" : "1/" + std::to_string(1 << halvings));
            return legend;
        }
        case ColourBy::thickness: {
            PanelScale legend{"colour: τ / d (0 flat, 1 ball)", {}};
            for (const auto& [ratio, label] :
                 {std::pair{0.0, "0"}, {0.05, "0.05"}, {0.2, "0.2"}, {0.5, "0.5"}, {1.0, "1"}})
                legend.ticks.emplace_back(std::sqrt(ratio), label);
            return legend;
        }
        case ColourBy::body:
            break;
    }
    return std::nullopt;
}

template double colour_magnitude(const ColourScale&, const Scb&, int);
template double colour_magnitude(const ColourScale&, const Ball&, int);
template double colour_magnitude(const ColourScale&, const Obb&, int);
template Rgba8 volume_colour(const ColourScale&, const Scb&, int, std::size_t, std::uint32_t);
template Rgba8 volume_colour(const ColourScale&, const Ball&, int, std::size_t, std::uint32_t);
template Rgba8 volume_colour(const ColourScale&, const Obb&, int, std::size_t, std::uint32_t);

}  // namespace scb
