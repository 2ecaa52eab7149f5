#include "scenes/meshes/gltf_check.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/platform/json_reader.h"
#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/gltf_document.h"
#include "scenes/meshes/little_endian.h"
#include "scenes/meshes/mesh_folder.h"

namespace scb::scenes {
namespace {

using nlohmann::json;

bool is_of_indices(std::size_t type) {
    return type == gltf_uint8 || type == gltf_uint16 || type == gltf_uint32;
}

std::optional<GltfElements> indices_of(GltfDocument& document, const json& accessor) {
    if (!accessor.contains("bufferView")) return std::nullopt;
    const std::size_t number = gltf_natural(accessor, "bufferView");
    const json& view = document.root.at("bufferViews").at(number);
    if (view.contains("extensions") && view.at("extensions").contains("EXT_meshopt_compression"))
        return std::nullopt;
    const std::size_t type = gltf_natural(accessor, "componentType");
    if (!is_of_indices(type)) return std::nullopt;
    return gltf_elements(document, number, gltf_natural(accessor, "byteOffset"), type, 1,
                         gltf_natural(accessor, "count"));
}

[[noreturn]] void refuse_index(const std::string& place, std::size_t i, std::uint64_t vertex,
                               std::size_t vertices) {
    throw InputError(place + ": index " + std::to_string(i) + " names vertex " +
                     std::to_string(vertex) + ", but there are " + std::to_string(vertices) +
                     " vertices, numbered from 0; repair the index.");
}

/// Refuses positions outside of the range that their accessor may read.
void check_position(GltfDocument& document, const json& position, bool in_draco,
                    const std::string& place) {
    const std::size_t type = gltf_natural(position, "componentType");
    const auto declares = [&](const char* list) {
        return document.root.contains(list) && document.root.at(list).is_array() &&
               std::find(document.root.at(list).begin(), document.root.at(list).end(),
                         "KHR_mesh_quantization") != document.root.at(list).end();
    };
    const bool quantized =
        type == gltf_int8 || type == gltf_uint8 || type == gltf_int16 || type == gltf_uint16;
    if (type != gltf_float &&
        !(quantized && (declares("extensionsUsed") || declares("extensionsRequired"))))
        throw InputError(place +
                         ": its positions are not float (KHR_mesh_quantization), which the file "
                         "does not declare; export it without quantization.");
    if (position.at("type") != "VEC3")
        throw InputError(place + ": its positions are not of the type VEC3; export it again.");
    if (in_draco) {
        // If assimp decodes them, it applies no factor.
        if (quantized && position.contains("normalized") && position.at("normalized").get<bool>())
            throw InputError(place +
                             ": its positions are normalized (KHR_mesh_quantization) and packed by "
                             "Draco, which would be misread; export it without quantization.");
        return;
    }
    if (!position.contains("bufferView") || position.contains("sparse")) return;
    const std::size_t number = gltf_natural(position, "bufferView");
    const GltfElements elements =
        gltf_elements(document, number, gltf_natural(position, "byteOffset"), type, 3,
                      gltf_natural(position, "count"));
    // assimp refuses missing buffers.
    if (!elements.bytes.empty() && !elements.are_there())
        throw InputError(place + ": its " + std::to_string(elements.count) +
                         " positions reach beyond buffer view " + std::to_string(number) +
                         " or its buffer; repair their count, offset or stride.");
}

void check_primitive(GltfDocument& document, const json& primitive, const std::string& place) {
    if (!gltf_has_triangles(primitive)) return;
    // assimp also reads attributes with this prefix as positions.
    for (const auto& [attribute, accessor] : primitive.at("attributes").items())
        if (attribute.starts_with("POSITION") && attribute != "POSITION")
            throw InputError(place + ": its attribute \"" + excerpt(attribute) +
                             "\" would be misread as the positions; export it again.");
    if (!primitive.at("attributes").contains("POSITION")) return;
    const json& accessors = document.root.at("accessors");
    const json& position = accessors.at(gltf_natural(primitive.at("attributes"), "POSITION"));
    const bool in_draco = gltf_is_in_draco(primitive);
    check_position(document, position, in_draco, place);
    if (in_draco || !primitive.contains("indices")) return;
    const std::size_t vertices = gltf_natural(position, "count");
    const json& accessor = accessors.at(gltf_natural(primitive, "indices"));
    if (accessor.contains("sparse")) {
        if (!is_of_indices(gltf_natural(accessor, "componentType")))
            throw InputError(place +
                             ": its indices are not unsigned whole numbers; export it again.");
        std::size_t i = 0;
        for (const double index : gltf_numbers(document, accessor, "SCALAR", place)) {
            if (index >= static_cast<double>(vertices))
                refuse_index(place, i, static_cast<std::uint64_t>(index), vertices);
            ++i;
        }
        return;
    }
    const auto indices = indices_of(document, accessor);
    if (!indices) return;
    std::string_view rest = indices->bytes;
    for (std::size_t i = 0; i < indices->count && rest.size() >= indices->size; ++i) {
        const std::uint32_t vertex = little_endian(rest, 0, indices->size);
        if (vertex >= vertices) refuse_index(place, i, vertex, vertices);
        rest.remove_prefix(std::min(indices->stride, rest.size()));
    }
}

/// Refuses buffers that assimp would misread.
void check_buffers(const JsonPlace& root, bool has_chunks) {
    if (!has(root, "buffers")) return;
    const JsonPlace buffers = field(root, "buffers");
    for (std::size_t i = 0; i < array_size(buffers, "buffers"); ++i) {
        const JsonPlace buffer = element(buffers, i);
        if (!(*buffer).is_object()) refuse_value(buffer, "an object");
        if (!has(buffer, "uri")) continue;
        const std::string uri = gltf_path(read_plain_text(field(buffer, "uri")));
        if (i == 0 && has_chunks)
            refuse(buffer,
                   "it has a uri, but the first buffer of a .glb is read from its binary chunk; "
                   "export a .gltf.");
        // assimp prepends the path of the folder to an absolute path, and also searches other
        // places.
        if (uri.starts_with("data:")) continue;
        if (uri.starts_with('/') ||
            !side_file(std::filesystem::path(root.file).parent_path() / uri, root.file))
            refuse_side_file(root.file, uri);
    }
}

void check_numbers(const JsonPlace& node, const char* name, std::size_t count) {
    if (!has(node, name)) return;
    const JsonPlace numbers = field(node, name);
    const std::string expected = std::to_string(count) + " numbers";
    if (array_size(numbers, expected.c_str()) != count) refuse_value(numbers, expected);
    for (std::size_t i = 0; i < count; ++i) read_number(element(numbers, i));
}

void check_names_of_nodes(const JsonPlace& owner, const char* name) {
    if (!has(owner, name)) return;
    const JsonPlace nodes = field(owner, name);
    for (std::size_t i = 0; i < array_size(nodes, "numbers of nodes"); ++i)
        if (const JsonPlace node = element(nodes, i); !(*node).is_number_unsigned())
            refuse_value(node, "the number of a node");
}

void check_nodes(const JsonPlace& root) {
    if (has(root, "scenes")) {
        const JsonPlace scenes = field(root, "scenes");
        for (std::size_t i = 0; i < array_size(scenes, "scenes"); ++i) {
            const JsonPlace scene = element(scenes, i);
            if (!(*scene).is_object()) refuse_value(scene, "an object");
            check_names_of_nodes(scene, "nodes");
        }
    }
    if (!has(root, "nodes")) return;
    const JsonPlace nodes = field(root, "nodes");
    for (std::size_t i = 0; i < array_size(nodes, "nodes"); ++i) {
        const JsonPlace node = element(nodes, i);
        if (!(*node).is_object()) refuse_value(node, "an object");
        check_names_of_nodes(node, "children");
        check_numbers(node, "matrix", 16);
        check_numbers(node, "translation", 3);
        check_numbers(node, "rotation", 4);
        check_numbers(node, "scale", 3);
    }
}

/// Extensions for the look of surfaces change no triangle.
void check_extensions(const JsonPlace& root) {
    if (!has(root, "extensionsRequired")) return;
    const JsonPlace required = field(root, "extensionsRequired");
    for (std::size_t i = 0; i < array_size(required, "names of extensions"); ++i) {
        const JsonPlace place = element(required, i);
        const std::string extension = read_text(place);
        constexpr std::string_view known[] = {"KHR_materials_",
                                              "EXT_materials_",
                                              "ADOBE_materials_",
                                              "MSFT_packing_",
                                              "KHR_techniques_webgl",
                                              "KHR_texture_",
                                              "EXT_texture_",
                                              "MSFT_texture_",
                                              "KHR_lights_",
                                              "EXT_lights_",
                                              "KHR_xmp",
                                              "KHR_mesh_quantization",
                                              "KHR_draco_mesh_compression",
                                              "EXT_mesh_gpu_instancing"};
        if (std::none_of(std::begin(known), std::end(known),
                         [&](std::string_view start) { return extension.starts_with(start); }))
            refuse(place, "the file needs the extension \"" + excerpt(extension) +
                              "\", which is not read; export it without.");
    }
}

}  // namespace

bool gltf_has_triangles(const json& primitive) {
    constexpr std::size_t triangles = 4, triangle_fan = 6;
    const std::size_t mode = gltf_natural(primitive, "mode", triangles);
    return mode >= triangles && mode <= triangle_fan;
}

bool gltf_is_in_draco(const json& primitive) {
    return primitive.contains("extensions") &&
           primitive.at("extensions").contains("KHR_draco_mesh_compression");
}

void for_each_primitive(GltfDocument& document,
                        const std::function<void(json&, const std::string&)>& action) {
    json& meshes = document.root.at("meshes");
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        if (!meshes[m].is_object() || !meshes[m].contains("primitives")) continue;
        json& primitives = meshes[m].at("primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const std::string place =
                document.name + ": mesh " + std::to_string(m) + ", primitive " + std::to_string(p);
            try {
                action(primitives.at(p), place);
            } catch (const json::exception&) {
                throw InputError(place +
                                 ": a field that it needs is missing or is of another kind; export "
                                 "it again.");
            }
        }
    }
}

void check_gltf(GltfDocument& document, bool has_chunks) {
    const JsonPlace root{&document.root, document.name, ""};
    check_extensions(root);
    check_buffers(root, has_chunks);
    check_nodes(root);
    for_each_primitive(document, [&](const json& primitive, const std::string& place) {
        check_primitive(document, primitive, place);
    });
}

}  // namespace scb::scenes
