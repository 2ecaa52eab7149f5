#pragma once

#include <filesystem>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads a mesh file: PLY (see ply_mesh), OBJ (see obj_mesh), OFF (see off_mesh), or what assimp
/// reads: STL, glTF, GLB, DAE, 3DS, FBX and more; not scenes that name meshes of their own (LWS,
/// IRR).
///
/// Every mesh that a node of the file's scene refers to is placed by the transforms of its node and
/// of the nodes above it, and all are joined, in the order of a walk from the root (a node's own
/// meshes before its children).
///
/// Polygons become triangles in place (see PolygonCutter); points and lines are dropped. Triangles
/// keep the order and the corners that they have in the file. Degenerate and duplicate triangles,
/// and unused vertices, stay.
///
/// Where a format has no shared vertices (STL), vertices with equal positions are repeated here;
/// the core, which looks at positions, does not mind.
///
/// assimp holds coordinates as float, and reads decimal text to within a unit in the last place of
/// it; PLY, OBJ and OFF are exact. Lengths are in the file's unit, but for COLLADA, whose unit is
/// applied. The up axis of a COLLADA file is left alone; 3DS comes out with y up.
///
/// What assimp reads is read in another process, see isolated_mesh, since its readers can crash on
/// broken files.
///
/// Throws MeshReaderError where that process cannot do its work, or memory runs out; and InputError
/// with one sentence that names the file, the place where known, and what to do: the file is
/// missing, a directory, empty, of a format that nothing reads, or broken; an index is out of
/// range; a used vertex is not finite; there is no triangle.
////// What of the file is not in the mesh, such as skins, is noted, see note_left_out.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace scb::scenes
