#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/enum_names.h"
#include "core/model/tree.h"
#include "render/overlay/side_panel.h"
#include "render/view/palette.h"

namespace scb::render {

/// What the color of a volume tells.
enum class ColorBy {
    body,    ///< which body it belongs to, in the categories of the palette, with slight variations
             ///< so that neighbours part
    depth,   ///< its level, viridis from the root to the deepest level
    radius,  ///< its diameter against the largest root's, viridis on a scale of halvings
    thickness,  ///< thickness over diameter, (e - f) / 2r, viridis from 0 (flat) to 1 (a whole
                ///< ball), on a square-root scale
    subtree,    ///< which of the eight subtrees below the third division it belongs to, as `body`
    surface,    ///< the share of the mesh's surface that it holds, against that of a level whose
                ///< volumes hold equal shares: viridis on a scale of doublings, equal in the middle
};

inline constexpr EnumNames<ColorBy, 6> color_by_names = {"body",      "depth",   "radius",
                                                         "thickness", "subtree", "surface"};

/// The scale that the pictures of a run share.
struct ColorScale {
    ColorBy by = ColorBy::body;
    int deepest = 0;           ///< for depth
    double root_diameter = 1;  ///< for radius
};

/// How many halvings the scale of `radius` spans.
inline constexpr int radius_halvings = 12;

/// How many doublings the scale of `surface` spans in each direction.
inline constexpr int surface_doublings = 6;

/// Of a volume that holds so many times as much of the surface as it would if all of its level held
/// equal shares.
double surface_magnitude(double times_equal_share);

/// Of what the volume itself tells: not `surface`.
double color_magnitude(const ColorScale& scale, const VolumeLengths& lengths, int depth);

/// `category`: its body, or its subtree, see subtrees_of.
Rgba8 volume_color(const ColorScale& scale, const VolumeLengths& lengths, int depth,
                   std::size_t category, std::uint32_t node);

/// For each node the subtree that ColorBy::subtree speaks of, 0 to 7. The nodes of a level above
/// the third of a binary tree have different ones.
std::vector<std::uint8_t> subtrees_of(const TreeShape& shape);

/// The largest diameter of the tree's roots.
double root_diameter(const Tree& tree);

/// The scale as a legend, or nothing where the colors are categories.
std::optional<PanelScale> legend_of(const ColorScale& scale);

}  // namespace scb::render
