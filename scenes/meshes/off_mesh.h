#pragma once

#include <string>
#include <string_view>

#include "scb/mesh.h"

namespace scb::scenes {

/// Whether a file starts as an OFF file does, text or binary: `OFF`, `COFF`, `4nOFF` and so on.
bool is_off(std::string_view start);

/// Reads the vertices and polygons of a text OFF file, in the order of the file. The numbers of a
/// vertex or of a face may continue on the next lines. The rest of their last line (normals,
/// colors, texture coordinates) is skipped, so each vertex and each face starts a line. The first
/// word may be missing. In `4OFF` the fourth number of a vertex divides the others; `nOFF` has a
/// dimension, 1 to 3, and missing coordinates are 0. PolygonCutter cuts faces of more than three
/// corners; faces of fewer are left out.
///
/// Throws InputError that names the file, and the wrong vertex or face if there is one: the file is
/// binary, something declared is missing, a word is not a number, a face names a vertex that does
/// not exist.
///
/// Source of the format: Geomview manual, "OFF: vertex-based polyhedra".
Mesh off_mesh(const std::string& path);

}  // namespace scb::scenes
