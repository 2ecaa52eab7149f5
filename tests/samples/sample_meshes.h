#pragma once

#include <string>

#include "scb/mesh.h"

namespace scb::samples {

/// A bracket as CAD programs export one, in millimeters: a plate with five round holes, and on it
/// two lugs with a hole each, about the axis y at the height 45. One closed surface; few vertices
/// on flat faces, so that many triangles are long and thin.
Mesh bracket();

/// A pin with a head that fits into the holes of the lugs with a clearance of 0.5: a surface of
/// revolution about y, with triangles as long as its shaft.
Mesh pin();

/// The text of a mesh file. Coordinates have four decimals, so the bytes are the same everywhere.
std::string ply_text(const Mesh& mesh);
std::string obj_text(const Mesh& mesh);

}  // namespace scb::samples
