#pragma once

#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads the vertices (`v`) and polygons (`f`) of a Wavefront OBJ file, in the order of the file;
/// everything else in it (materials, groups, normals, texture coordinates, points, lines, curves)
/// is passed over, and no other file is opened. Faces of more than three corners are cut by
/// PolygonCutter; of fewer they are left out. A corner may be counted from the end (-1 is the last
/// vertex so far), and may name a vertex that comes later.
///
/// Throws InputError that names the file and the line at fault: a vertex that is not 3, 4, 6 or 7
/// numbers (a weight, which curves alone use, and a color are passed over), a corner that is
/// not a whole number or names no vertex, a line of more than 1 MiB, or more than 2^28 vertices or
/// corners.
///
/// Source of the format: Wavefront, "Advanced Visualizer Manual", appendix B1, object files (.obj).
Mesh obj_mesh(const std::string& path);

}  // namespace scb::scenes
