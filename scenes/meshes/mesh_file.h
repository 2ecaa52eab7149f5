#pragma once

#include <filesystem>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads a mesh file: PLY (see ply_mesh), OBJ (see obj_mesh), OFF (see off_mesh), or the formats of
/// assimp: STL, glTF, GLB, DAE, 3DS, FBX and more; not scenes that name other mesh files (LWS,
/// IRR).
///
/// Every mesh of a node of the file's scene is placed by the transforms of this node and of the
/// nodes above it. All are joined in the order of a walk from the root (a node's own meshes before
/// its children).
///
/// Polygons become triangles in place (see PolygonCutter); points and lines are dropped. Triangles
/// keep the order and the corners that they have in the file. Degenerate and duplicate triangles,
/// and unused vertices, stay.
///
/// If a format has no shared vertices (STL), vertices with equal positions are repeated; the core
/// joins vertices by their positions.
///
/// assimp stores coordinates as float, and reads decimal text to within a unit in the last place of
/// float; PLY, OBJ and OFF are exact. Lengths are in the file's unit, except that the unit of
/// COLLADA is applied. The up axis of a COLLADA file is not applied; 3DS gets y up.
///
/// Another process reads the formats of assimp, see isolated_mesh, since assimp's readers can crash
/// on broken files.
///
/// Throws MeshReaderError if that process cannot do its work, or memory runs out; and InputError
/// with one sentence that names the file, the place if known, and what to do: the file is missing,
/// a directory, empty, of an unknown format, or broken; an index is out of range; a used vertex is
/// not finite; there is no triangle.
///
/// Parts of the file that are not in the mesh, such as skins, are noted, see note_left_out.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace scb::scenes
