#pragma once

#include <optional>
#include <span>
#include <string>

namespace scb {

/// Where the corners of a packed leaf's triangles are.
enum class LeafCorners {
    stored,   ///< in the leaf: 36 bytes for each triangle
    in_mesh,  ///< in the mesh alone
};

/// How a packed hierarchy is stored: the numbers of its volumes, the width of its nodes, the size
/// of its leaves, and where the corners of triangles are.
struct PackedLayout {
    /// The numbers of stored volumes.
    enum class Numbers {
        floats,    ///< 36 bytes for a volume, 44 with two slabs, see FloatCodec
        quantized  ///< 18 bytes, or 22, see QuantizedCodec
    };
    /// The numbers of stored volumes.
    Numbers numbers = Numbers::floats;
    int width = 8;           ///< 2, 4 or 8
    int leaf_triangles = 4;  ///< 1 to 4, at most
    /// Where the corners of a leaf's triangles are. With `in_mesh`, a query gathers them from the
    /// mesh.
    LeafCorners corners = LeafCorners::stored;
};

/// The name of a layout on the command line, without the size of its leaves: "float8",
/// "quantized2", or "indexed2" for quantized numbers and corners in the mesh.
std::string packed_layout_name(const PackedLayout& layout);
/// The layout with this name, with leaves of four triangles; no value if no layout has the name.
std::optional<PackedLayout> packed_layout_of(std::string_view name);

/// All layouts, with leaves of four triangles.
std::span<const PackedLayout> all_packed_layouts();

}  // namespace scb
