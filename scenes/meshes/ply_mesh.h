#pragma once

#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads a PLY file: text or binary of either byte order; `vertex` with x, y and z, `face` with a
/// list of vertex_indices (or vertex_index, vertex_indexes, vert_indices), and `tristrips`, in
/// which -1 starts a new strip. Triangles of strips that name a vertex twice only connect strips,
/// and are left out. Other elements and properties are skipped. Elements may be in any order.
/// PolygonCutter cuts faces of more than three corners; faces of fewer are left out.
///
/// Coordinates have the precision that the header declares, float or double. The file is read once
/// from front to back, or twice if faces are before vertices, with 1 MiB of memory beside the mesh.
///
/// Throws InputError that names the file and the header line, vertex or face at fault: something
/// that the header declares is missing, is not a number, occurs twice, names a vertex that does not
/// exist, or is more than 2^28 vertices or corners; or the file continues with something other than
/// blanks.
Mesh ply_mesh(const std::string& path);

}  // namespace scb::scenes
