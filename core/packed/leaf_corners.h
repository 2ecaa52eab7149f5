#pragma once

namespace scb {

/// Where the corners of a packed leaf's triangles are.
enum class LeafCorners {
    stored,   ///< in the leaf: 36 bytes for each triangle
    in_mesh,  ///< in the mesh alone
};

}  // namespace scb
