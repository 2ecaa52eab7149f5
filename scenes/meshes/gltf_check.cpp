#include "scenes/meshes/gltf_check.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "scb/error.h"
#include "scenes/meshes/little_endian.h"
#include "scenes/meshes/mesh_folder.h"
#include "scenes/text/file_bytes.h"

namespace scb::scenes {
namespace {

using nlohmann::json;

struct Container {
    std::string_view text;    ///< the JSON
    std::string_view binary;  ///< the chunk of a .glb that follows it
};

/// A .gltf is its JSON. A .glb has a header of 12 bytes and chunks of length, type and data; the
/// first is the JSON, the second the buffer without a URI.
Container parts_of(std::string_view bytes) {
    if (bytes.substr(0, 4) != "glTF") return {bytes, {}};
    if (bytes.size() < 20) return {};
    const std::size_t length = little_endian(bytes, 12, 4);
    Container parts{bytes.substr(20, length), {}};
    if (bytes.size() < 28 || length > bytes.size() - 28) return parts;
    parts.binary = bytes.substr(28 + length, little_endian(bytes, 20 + length, 4));
    return parts;
}

std::string decode_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        constexpr std::string_view letters =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t value = letters.find(c);
        if (value == std::string_view::npos) break;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255);
    }
    return bytes;
}

std::string bytes_or_nothing(const std::filesystem::path& buffer, const std::string& mesh) {
    const auto file = side_file(buffer, mesh);
    if (!file) return {};
    try {
        return file_bytes(file->string());
    } catch (const InputError&) {
        return {};
    }
}

/// The document and the bytes of its buffers, each fetched once.
struct Document {
    json root;
    std::string_view binary;
    std::string name;  ///< of the file
    std::map<std::size_t, std::string> fetched;

    /// Empty where the bytes are missing. Throws json::exception where the document has no such
    /// buffer.
    std::string_view buffer(std::size_t index) {
        const json& entry = root.at("buffers").at(index);
        if (!entry.contains("uri")) return binary;
        const auto found = fetched.find(index);
        if (found != fetched.end()) return found->second;
        const auto& uri = entry.at("uri").get_ref<const std::string&>();
        constexpr std::string_view mark = ";base64,";
        const std::size_t data = uri.find(mark);
        std::string& bytes = fetched[index];
        if (uri.rfind("data:", 0) != 0)
            bytes = bytes_or_nothing(std::filesystem::path(name).parent_path() / uri, name);
        else if (data != std::string::npos)
            bytes = decode_base64(std::string_view(uri).substr(data + mark.size()));
        return bytes;
    }
};

std::size_t natural(const json& object, const char* key) {
    return object.contains(key) ? object.at(key).get<std::size_t>() : 0;
}

/// The bytes of an accessor's numbers, `count` of `size` bytes, one every `stride` bytes.
struct Indices {
    std::string_view bytes;
    std::size_t size = 0, stride = 0, count = 0;
};

std::optional<Indices> indices_of(Document& document, const json& accessor) {
    if (accessor.contains("sparse") || !accessor.contains("bufferView")) return std::nullopt;
    const json& view = document.root.at("bufferViews").at(natural(accessor, "bufferView"));
    if (view.contains("extensions") && view.at("extensions").contains("EXT_meshopt_compression"))
        return std::nullopt;
    Indices indices;
    switch (natural(accessor, "componentType")) {
        case 5121:
            indices.size = 1;
            break;
        case 5123:
            indices.size = 2;
            break;
        case 5125:
            indices.size = 4;
            break;
        default:
            return std::nullopt;
    }
    indices.count = natural(accessor, "count");
    indices.stride = std::max(natural(view, "byteStride"), indices.size);
    const std::string_view buffer = document.buffer(natural(view, "buffer"));
    const std::size_t view_start = std::min(natural(view, "byteOffset"), buffer.size());
    const std::string_view view_bytes = buffer.substr(view_start, natural(view, "byteLength"));
    indices.bytes = view_bytes.substr(std::min(natural(accessor, "byteOffset"), view_bytes.size()));
    return indices;
}

void check_primitive(Document& document, const json& primitive, const std::string& place) {
    constexpr int triangles = 4, triangle_fan = 6;
    const int mode = primitive.value("mode", triangles);
    if (mode < triangles || mode > triangle_fan) return;
    if (primitive.contains("extensions") &&
        primitive.at("extensions").contains("KHR_draco_mesh_compression"))
        return;
    if (!primitive.at("attributes").contains("POSITION")) return;
    const json& accessors = document.root.at("accessors");
    const json& position = accessors.at(natural(primitive.at("attributes"), "POSITION"));
    constexpr std::size_t is_float = 5126;
    if (natural(position, "componentType") != is_float)
        throw InputError(place +
                         ": its positions are not float (KHR_mesh_quantization), which would be "
                         "misread; export it without quantization.");
    if (!primitive.contains("indices")) return;
    const std::size_t vertices = natural(position, "count");
    const auto indices = indices_of(document, accessors.at(natural(primitive, "indices")));
    if (!indices) return;
    std::string_view rest = indices->bytes;
    for (std::size_t i = 0; i < indices->count && rest.size() >= indices->size; ++i) {
        const std::uint32_t vertex = little_endian(rest, 0, indices->size);
        if (vertex >= vertices)
            throw InputError(place + ": index " + std::to_string(i) + " names vertex " +
                             std::to_string(vertex) + ", but there are " +
                             std::to_string(vertices) +
                             " vertices, numbered from 0; repair the index.");
        rest.remove_prefix(std::min(indices->stride, rest.size()));
    }
}

}  // namespace

void check_gltf(std::string_view bytes, const std::string& name) {
    const Container parts = parts_of(bytes);
    Document document{
        json::parse(parts.text.begin(), parts.text.end(), nullptr, false), parts.binary, name, {}};
    const std::size_t last = bytes.find_last_not_of(" \t\r\n");
    if (document.root.is_discarded() && bytes[0] == '{' && bytes[last] != '}')
        throw InputError(name +
                         ": the file is cut off, since its JSON has no end; export it again.");
    if (!document.root.is_object() || !document.root.contains("meshes")) return;
    const json& meshes = document.root.at("meshes");
    // glTF 1 names its meshes by the keys of an object.
    if (!meshes.is_array()) return;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        if (!meshes[m].is_object() || !meshes[m].contains("primitives")) continue;
        const json& primitives = meshes[m].at("primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const std::string place =
                name + ": mesh " + std::to_string(m) + ", primitive " + std::to_string(p);
            try {
                check_primitive(document, primitives.at(p), place);
            } catch (const json::exception&) {
                // A document that is not put together as glTF 2 wants it.
            }
        }
    }
}

}  // namespace scb::scenes
