#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/mesh.h"

namespace scb {

/// A mesh of one color in a file that other viewers read.
struct ExportPart {
    std::string name;
    Mesh mesh;                    ///< in the world
    std::array<float, 3> color;  ///< red, green, blue, 0 to 1
};

/// The bytes of a mesh file with these parts; the format is that of the path's extension: .ply
/// (binary), .obj, .glb or .stl. Throws InputError for another extension.
std::vector<std::uint8_t> encode_mesh(const std::vector<ExportPart>& parts,
                                      const std::filesystem::path& path);

}  // namespace scb
