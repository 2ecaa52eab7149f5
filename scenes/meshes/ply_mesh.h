#pragma once

#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads a PLY file: text or binary of either byte order; `vertex` with x, y and z, `face` with a
/// list of vertex_indices (or vertex_index, vertex_indexes, vert_indices), and `tristrips`, in
/// which -1 starts a new strip and triangles that name a vertex twice, which only lead from strip
/// to strip, are left out. Other elements and properties are passed over. Elements may stand in any
/// order. Faces of more than three corners are cut by PolygonCutter; of fewer they are left out.
///
/// Coordinates have the precision that the header declares, float or double. The file is read once
/// from front to back, or twice where faces stand before vertices, with 1 MiB of memory beside the
/// mesh.
///
/// Throws InputError that names the file and the header line, vertex or face at fault: something
/// that the header declares is missing, is not a number, stands twice, names a vertex that does not
/// exist, or is more than 2^28 vertices or corners; or something else than blanks follows it.
Mesh ply_mesh(const std::string& path);

}  // namespace scb::scenes
