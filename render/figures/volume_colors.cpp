#include "render/figures/volume_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/base/portable_math.h"
#include "render/overlay/figure_layout.h"

namespace scb::render {
namespace {

// Lighter or darker by up to a tenth, the same for a node in every picture.
Rgba8 varied(Rgba8 color, std::uint32_t node) {
    const double t = static_cast<double>((node * 2654435761u) >> 16) / 65535.0 * 2 - 1;
    return t > 0 ? mix(color, {255, 255, 255}, 0.16 * t) : mix(color, {0, 0, 0}, -0.12 * t);
}

}  // namespace

double surface_magnitude(double times_equal_share) {
    if (!(times_equal_share > 0)) return 0;
    return std::clamp(0.5 + 0.5 * binary_logarithm(times_equal_share) / surface_doublings, 0.0,
                      1.0);
}

double color_magnitude(const ColorScale& scale, const VolumeLengths& lengths, int depth) {
    const double d = lengths.diameter;
    switch (scale.by) {
        case ColorBy::depth:
            return scale.deepest == 0 ? 0 : static_cast<double>(depth) / scale.deepest;
        case ColorBy::radius:
            return d > 0
                       ? std::clamp(1 + binary_logarithm(d / scale.root_diameter) / radius_halvings,
                                    0.0, 1.0)
                       : 0;
        // Most volumes of a deep level are nearly flat: the square root separates them.
        case ColorBy::thickness:
            return d > 0 ? std::sqrt(lengths.thickness / d) : 0;
        case ColorBy::body:
        case ColorBy::subtree:
        case ColorBy::surface:
            break;
    }
    return 0;
}

Rgba8 volume_color(const ColorScale& scale, const VolumeLengths& lengths, int depth,
                   std::size_t category, std::uint32_t node) {
    if (scale.by == ColorBy::body || scale.by == ColorBy::subtree)
        return varied(category_color(category), node);
    return viridis(color_magnitude(scale, lengths, depth));
}

std::optional<PanelScale> legend_of(const ColorScale& scale) {
    switch (scale.by) {
        case ColorBy::depth: {
            PanelScale legend{"color: level of the node", {}};
            const int step = scale.deepest <= 6 ? 1 : (scale.deepest + 5) / 6;
            for (int level = 0; level <= scale.deepest; level += step)
                legend.ticks.emplace_back(
                    scale.deepest == 0 ? 0 : static_cast<double>(level) / scale.deepest,
                    std::to_string(level));
            return legend;
        }
        case ColorBy::radius: {
            PanelScale legend{"color: d / " + number_text(scale.root_diameter) + " (the root's)",
                              {}};
            for (int halvings = radius_halvings; halvings >= 0; halvings -= 3)
                legend.ticks.emplace_back(
                    1 - static_cast<double>(halvings) / radius_halvings,
                    halvings == 0 ? "1" : "1/" + std::to_string(1 << halvings));
            return legend;
        }
        case ColorBy::thickness: {
            PanelScale legend{"color: τ / d (0 flat, 1 ball)", {}};
            for (const auto& [ratio, label] :
                 {std::pair{0.0, "0"}, {0.05, "0.05"}, {0.2, "0.2"}, {0.5, "0.5"}, {1.0, "1"}})
                legend.ticks.emplace_back(std::sqrt(ratio), label);
            return legend;
        }
        case ColorBy::surface: {
            PanelScale legend{"color: share of the surface / equal share", {}};
            for (int doublings = -surface_doublings; doublings <= surface_doublings; doublings += 3)
                legend.ticks.emplace_back(
                    0.5 + 0.5 * doublings / surface_doublings,
                    (doublings < 0 ? "1/" : "") + std::to_string(1 << std::abs(doublings)));
            return legend;
        }
        case ColorBy::body:
        case ColorBy::subtree:
            break;
    }
    return std::nullopt;
}

std::vector<std::uint8_t> subtrees_of(const TreeShape& shape) {
    constexpr std::uint32_t divisions = 3;
    std::vector<std::uint8_t> subtrees(shape.size());
    for (const std::uint32_t node : shape.order) {
        const bool divides = shape.depths[node] < divisions;
        unsigned side = 0;
        for (std::uint32_t child = shape.first_child[node]; child != no_index;
             child = shape.next_sibling[child], ++side)
            subtrees[child] = static_cast<std::uint8_t>(divides ? (2u * subtrees[node] + side) % 8
                                                                : subtrees[node]);
    }
    return subtrees;
}

double root_diameter(const Tree& tree) {
    double largest = 0;
    for (const std::uint32_t root : tree.shape().roots)
        if (tree.has_volume(root)) largest = std::max(largest, tree.lengths(root).diameter);
    return largest;
}

}  // namespace scb::render
