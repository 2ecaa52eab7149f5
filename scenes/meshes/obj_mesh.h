#pragma once

#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads the vertices (`v`) and polygons (`f`) of a Wavefront OBJ file, in the order of the file;
/// everything else in it (materials, groups, normals, texture coordinates, points, lines, curves)
/// is skipped, and no other file is opened. PolygonCutter cuts faces of more than three corners;
/// faces of fewer are left out. A corner may be counted from the end (-1 is the last vertex so
/// far), and may name a later vertex.
///
/// Throws InputError that names the file and the line at fault: a vertex that is not 3, 4, 6 or 7
/// numbers (a weight, which only curves use, and a color are skipped), a corner that is not an
/// integer or names no vertex, a line of more than 1 MiB, or more than 2^28 vertices or corners.
///
/// Source of the format: Wavefront, "Advanced Visualizer Manual", appendix B1, object files (.obj).
Mesh obj_mesh(const std::string& path);

}  // namespace scb::scenes
