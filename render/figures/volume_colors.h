#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/enum_names.h"
#include "core/model/tree.h"
#include "render/overlay/side_panel.h"
#include "render/view/palette.h"

namespace scb::render {

/// The meaning of the color of a volume.
enum class ColorBy {
    body,    ///< its body, in the categories of the palette, with slight variations to distinguish
             ///< neighbours
    depth,   ///< its level, viridis from the root to the deepest level
    radius,  ///< its diameter relative to the largest root's, viridis on a scale of halvings
    thickness,  ///< thickness over diameter, (e - f) / 2r, viridis from 0 (flat) to 1 (a whole
                ///< ball), on a square-root scale
    subtree,    ///< its subtree, one of eight below the third division, as `body`
    surface,    ///< its share of the mesh's surface, relative to equal shares of all volumes of the
                ///< level: viridis on a scale of doublings, equal in the middle
};

inline constexpr EnumNames<ColorBy, 6> color_by_names = {"body",      "depth",   "radius",
                                                         "thickness", "subtree", "surface"};

/// The common scale of the pictures of a run.
struct ColorScale {
    ColorBy by = ColorBy::body;
    int deepest = 0;           ///< for depth
    double root_diameter = 1;  ///< for radius
};

/// The number of halvings that the scale of `radius` spans.
inline constexpr int radius_halvings = 12;

/// The number of doublings that the scale of `surface` spans in each direction.
inline constexpr int surface_doublings = 6;

/// The magnitude of a volume whose share of the surface is a multiple of the equal share of all
/// volumes of its level.
double surface_magnitude(double times_equal_share);

/// The magnitude for measures of the volume itself, so not for `surface`.
double color_magnitude(const ColorScale& scale, const VolumeLengths& lengths, int depth);

/// `category`: its body, or its subtree, see subtrees_of.
Rgba8 volume_color(const ColorScale& scale, const VolumeLengths& lengths, int depth,
                   std::size_t category, std::uint32_t node);

/// For each node, the subtree of ColorBy::subtree, 0 to 7. In a binary tree, the nodes of one level
/// above the third have different ones.
std::vector<std::uint8_t> subtrees_of(const TreeShape& shape);

/// The largest diameter of the tree's roots.
double root_diameter(const Tree& tree);

/// The scale as a legend, or nothing if the colors are categories.
std::optional<PanelScale> legend_of(const ColorScale& scale);

}  // namespace scb::render
