#pragma once

#include <functional>
#include <optional>

#include "core/model/tree.h"
#include "render/view/palette.h"
#include "render/web/block_store.h"

namespace scb::render {

/// How a volume is drawn in a browser; what its numbers are, in the tree's frame, with centers from
/// TreeBlocks::center.
enum class WebShape : std::uint8_t {
    none,      ///< the node has no volume
    scb,       ///< c, r, n, e, f: 9 numbers; of a ball e = r, f = -r
    scb2,      ///< c, r, n, e, n, e, f, f: 14
    box,       ///< center, half, axis, half, axis, half: 12
    polytope,  ///< center, the radius of a ball about all of it; its planes are extra
    rounded,   ///< center, the radius of such a ball, rounding; the points of its core are extra
};

/// The nodes of a few levels that follow each other: small ones are packed together.
struct LevelBlocks {
    std::size_t levels = 0;
    // Numbers of blocks. Of each node:
    std::size_t shapes = 0;   ///< its WebShape, u8
    std::size_t numbers = 0;  ///< the numbers of its shape, one node after the other, f32
    std::size_t extras = 0;   ///< how many planes or points it has, u32
    std::size_t texels = 0;   ///< these, four f32 each: unit normal and offset; point and 0
    std::size_t colors = 0;   ///< red, green, blue, u8
    bool has_extras = false;  ///< else there are no blocks of that name
};

/// A tree by its levels, from the root down: a page that shows the first ones unpacks no others.
struct TreeBlocks {
    Vec3 center = Vec3::Zero();       ///< what all centers count from, so that 32 bits are enough
    std::vector<std::size_t> counts;  ///< the nodes of each level; those that no root leads to are
                                      ///< left out
    // Numbers of blocks, each u32:
    std::size_t order = 0;        ///< the nodes' indices, level by level, and within a level child
                                  ///< after child of node after node
    std::size_t children = 0;     ///< in this order how many children each has,
    std::size_t item_counts = 0;  ///< and how many triangles, or objects
    std::size_t items = 0;        ///< these, one node after the other
    /// In this order, too, what users call each; nothing where these are the indices.
    std::optional<std::size_t> numbers;
    std::vector<LevelBlocks> parts;
};

/// `color` returns the color of a node.
TreeBlocks tree_blocks(const Tree& tree, const std::function<Rgba8(std::uint32_t)>& color,
                       BlockStore& store);

}  // namespace scb::render
