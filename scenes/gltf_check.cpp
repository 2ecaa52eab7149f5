#include "scenes/gltf_check.h"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace scb {
namespace {

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
}

/// The JSON text: the whole of a .gltf, the first chunk of a .glb (header of 12 bytes, then length,
/// type, data).
std::string_view json_part(std::string_view bytes) {
    if (bytes.substr(0, 4) != "glTF") return bytes;
    if (bytes.size() < 20) return {};
    return bytes.substr(20, little_endian(bytes, 12));
}

}  // namespace

std::vector<std::size_t> gltf_triangle_counts(std::string_view bytes) {
    const std::string_view text = json_part(bytes);
    std::vector<std::size_t> counts;
    try {
        const nlohmann::json document = nlohmann::json::parse(text.begin(), text.end());
        for (const auto& mesh : document.at("meshes")) {
            for (const auto& primitive : mesh.at("primitives")) {
                constexpr int triangle_list = 4;
                const auto& accessor = primitive.contains("indices")
                                           ? primitive.at("indices")
                                           : primitive.at("attributes").at("POSITION");
                const auto corners =
                    document.at("accessors").at(accessor.get<std::size_t>()).at("count");
                counts.push_back(primitive.value("mode", triangle_list) == triangle_list
                                     ? corners.get<std::size_t>() / 3
                                     : 0);
            }
        }
    } catch (const nlohmann::json::exception&) {
        // glTF 1 and broken files: assimp reads or refuses them.
        return {};
    }
    return counts;
}

}  // namespace scb
