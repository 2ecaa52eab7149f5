#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scb/mesh.h"

namespace scb::scenes {

/// A mesh of one color in a file for other viewers.
struct ExportPart {
    std::string name;
    Mesh mesh;                   ///< in the world
    std::array<float, 3> color;  ///< red, green, blue, 0 to 1
};

/// The bytes of a mesh file with these parts, in order; the path's extension selects the format:
/// .ply (text: the binary writer of assimp 5.2 breaks files with colors), .obj, .glb or .stl
/// (binary). In .obj and .glb every part keeps its name; in .glb it is a node and a mesh of its
/// own. .stl has neither colors nor names.
///
/// All four store coordinates rounded to float. Throws InputError for another extension, and for a
/// coordinate beyond the range of float.
std::vector<std::uint8_t> encode_mesh(const std::vector<ExportPart>& parts,
                                      const std::filesystem::path& path);

}  // namespace scb::scenes
