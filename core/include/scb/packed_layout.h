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

/// How a packed hierarchy is stored: as what numbers, how many children a node has, how many
/// triangles a leaf, and with or without their corners.
struct PackedLayout {
    /// As what volumes are stored.
    enum class Numbers {
        floats,    ///< 36 bytes for a volume, 44 with two slabs, see FloatCodec
        quantized  ///< 18 bytes, or 22, see QuantizedCodec
    };
    /// As what volumes are stored.
    Numbers numbers = Numbers::floats;
    int width = 8;           ///< 2, 4 or 8
    int leaf_triangles = 4;  ///< 1 to 4, at most
    /// Where a leaf's corners are: in it, or in the mesh alone, from where a query gathers them.
    LeafCorners corners = LeafCorners::stored;
};

/// How a layout is named on the command line, but for the size of its leaves: "float8",
/// "quantized2", and "indexed2" where numbers are quantized and corners in the mesh.
std::string packed_layout_name(const PackedLayout& layout);
/// The layout of this name, with leaves of four triangles, or nothing where there is none.
std::optional<PackedLayout> packed_layout_of(std::string_view name);

/// All of them, with leaves of four triangles.
std::span<const PackedLayout> all_packed_layouts();

}  // namespace scb
