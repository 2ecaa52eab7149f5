#pragma once

#include <string>
#include <string_view>

#include "scb/mesh.h"

namespace scb::scenes {

/// Whether a file starts as an OFF file does, text or binary: `OFF`, `COFF`, `4nOFF` and so on.
bool is_off(std::string_view start);

/// Reads the vertices and polygons of a text OFF file, in the order of the file. The numbers of a
/// vertex or of a face may go on in the next lines; what follows them in their last line (normals,
/// colors, texture coordinates) is passed over, so each vertex and each face starts a line. The
/// first word may be missing. Of `4OFF` the fourth number of a vertex divides the others; `nOFF`
/// says its dimension, 1 to 3, and the coordinates that it lacks are 0. Faces of more than three
/// corners are cut by PolygonCutter; of fewer they are left out.
///
/// Throws InputError that names the file, and the vertex or face at fault where there is one: the
/// file is binary, what is declared is not there, a number is none, a face names a vertex that does
/// not exist.
///
/// Source of the format: Geomview manual, "OFF: vertex-based polyhedra".
Mesh off_mesh(const std::string& path);

}  // namespace scb::scenes
