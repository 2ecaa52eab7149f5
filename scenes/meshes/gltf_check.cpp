#include "scenes/meshes/gltf_check.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "scb/error.h"
#include "scenes/meshes/confinement.h"
#include "scenes/meshes/little_endian.h"
#include "scenes/meshes/mesh_folder.h"
#include "scenes/text/file_bytes.h"
#include "scenes/text/json_reader.h"
#include "scenes/text/tokens.h"

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
    // Some writers pad with zeros, not with spaces.
    parts.text = parts.text.substr(0, parts.text.find_last_not_of('\0') + 1);
    if (bytes.size() < 28 || length > bytes.size() - 28) return parts;
    parts.binary = bytes.substr(28 + length, little_endian(bytes, 20 + length, 4));
    return parts;
}

/// Nothing where a letter is none of the code.
std::optional<std::string> decode_base64(std::string_view text) {
    std::string bytes;
    text = text.substr(0, text.find_last_not_of('=') + 1);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        constexpr std::string_view letters =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t value = letters.find(c);
        if (value == std::string_view::npos) return std::nullopt;
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
        std::error_code error;
        if (const auto size = std::filesystem::file_size(*file, error); !error) allow_for(size);
        return file_bytes(file->string());
    } catch (const InputError&) {
        return {};
    }
}

/// The uri of a buffer as assimp looks for it.
std::string as_path(std::string uri) {
    if (!uri.starts_with("data:")) std::replace(uri.begin(), uri.end(), '\\', '/');
    return uri;
}

/// The document and the bytes of its buffers, each fetched once.
struct Document {
    json root;
    std::string_view binary;
    std::string name;                                      ///< of the file
    std::map<std::string, std::string> files{};            ///< bytes, by uri
    std::map<std::size_t, std::string> decoded_buffers{};  ///< those of data uris
    std::map<std::size_t, std::string_view> fetched{};     ///< either

    /// Empty where the bytes are missing. Throws json::exception where the document has no such
    /// buffer, and InputError where its base64 is damaged.
    std::string_view buffer(std::size_t index) {
        const json& entry = root.at("buffers").at(index);
        if (!entry.contains("uri")) return binary;
        const auto found = fetched.find(index);
        if (found != fetched.end()) return found->second;
        const auto& uri = entry.at("uri").get_ref<const std::string&>();
        std::string_view& bytes = fetched[index];
        constexpr std::string_view mark = ";base64,";
        const std::size_t data = uri.find(mark);
        if (!uri.starts_with("data:")) {
            // However many buffers name it.
            const auto [file, is_new] = files.try_emplace(as_path(uri));
            if (is_new)
                file->second =
                    bytes_or_nothing(std::filesystem::path(name).parent_path() / file->first, name);
            bytes = file->second;
        } else if (data != std::string::npos) {
            std::string& own = decoded_buffers[index];
            own = decoded(std::string_view(uri).substr(data + mark.size()), index);
            bytes = own;
        }
        return bytes;
    }

  private:
    std::string decoded(std::string_view text, std::size_t index) const {
        std::optional<std::string> bytes = decode_base64(text);
        if (!bytes)
            throw InputError(name + ": buffer " + std::to_string(index) +
                             ": its base64 is damaged; export the file again.");
        return std::move(*bytes);
    }
};

/// Throws json::exception where it is no whole number from 0.
std::size_t natural(const json& object, const char* key, std::size_t otherwise = 0) {
    return object.contains(key) ? object.at(key).get_ref<const json::number_unsigned_t&>()
                                : otherwise;
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
    constexpr std::size_t triangles = 4, triangle_fan = 6;
    const std::size_t mode = natural(primitive, "mode", triangles);
    if (mode < triangles || mode > triangle_fan) return;
    if (primitive.contains("extensions") &&
        primitive.at("extensions").contains("KHR_draco_mesh_compression"))
        return;
    // assimp takes what starts like this for the positions as well.
    for (const auto& [attribute, accessor] : primitive.at("attributes").items())
        if (attribute.starts_with("POSITION") && attribute != "POSITION")
            throw InputError(place + ": its attribute \"" + excerpt(attribute) +
                             "\" would be misread as the positions; export it again.");
    if (!primitive.at("attributes").contains("POSITION")) return;
    const json& accessors = document.root.at("accessors");
    const json& position = accessors.at(natural(primitive.at("attributes"), "POSITION"));
    constexpr std::size_t is_float = 5126;
    if (natural(position, "componentType") != is_float)
        throw InputError(place +
                         ": its positions are not float (KHR_mesh_quantization), which would be "
                         "misread; export it without quantization.");
    if (position.at("type") != "VEC3")
        throw InputError(place + ": its positions are not of the type VEC3; export it again.");
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

/// What assimp would read in another way than it is written.
void check_buffers(const JsonPlace& root, bool has_chunks) {
    if (!has(root, "buffers")) return;
    const JsonPlace buffers = field(root, "buffers");
    for (std::size_t i = 0; i < array_size(buffers, "buffers"); ++i) {
        const JsonPlace buffer = element(buffers, i);
        if (!(*buffer).is_object()) refuse_value(buffer, "an object");
        if (!has(buffer, "uri")) continue;
        const std::string uri = as_path(read_plain_text(field(buffer, "uri")));
        if (i == 0 && has_chunks)
            refuse(buffer,
                   "it has a uri, but the first buffer of a .glb is read from its binary chunk; "
                   "export a .gltf.");
        // assimp puts the path of the folder before an absolute one, and looks in other places too.
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

/// Those of how a surface looks change no triangle; quantization is refused where it is used.
void check_extensions(const JsonPlace& root) {
    if (!has(root, "extensionsRequired")) return;
    const JsonPlace required = field(root, "extensionsRequired");
    for (std::size_t i = 0; i < array_size(required, "names of extensions"); ++i) {
        const JsonPlace place = element(required, i);
        const std::string extension = read_text(place);
        constexpr std::string_view known[] = {
            "KHR_materials_",        "KHR_texture_",
            "EXT_texture_",          "MSFT_texture_",
            "KHR_lights_",           "KHR_xmp",
            "KHR_mesh_quantization", "KHR_draco_mesh_compression"};
        if (std::none_of(std::begin(known), std::end(known),
                         [&](std::string_view start) { return extension.starts_with(start); }))
            refuse(place, "the file needs the extension \"" + excerpt(extension) +
                              "\", which is not read; export it without.");
    }
}

}  // namespace

void check_gltf(std::string_view bytes, const std::string& name) {
    const Container parts = parts_of(bytes);
    const std::size_t last = parts.text.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) return;
    if (parts.text[last] != '}')
        throw InputError(name +
                         ": the file is cut off, since its JSON has no end; export it again.");
    Document document{parse_json(parts.text, name), parts.binary, name};
    const JsonPlace root{&document.root, name, ""};
    if (!document.root.is_object() || !document.root.contains("meshes")) return;
    const json& meshes = document.root.at("meshes");
    // glTF 1 names its meshes by the keys of an object.
    if (!meshes.is_array()) return;
    check_extensions(root);
    check_buffers(root, bytes.starts_with("glTF"));
    check_nodes(root);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        if (!meshes[m].is_object() || !meshes[m].contains("primitives")) continue;
        const json& primitives = meshes[m].at("primitives");
        for (std::size_t p = 0; p < primitives.size(); ++p) {
            const std::string place =
                name + ": mesh " + std::to_string(m) + ", primitive " + std::to_string(p);
            try {
                check_primitive(document, primitives.at(p), place);
            } catch (const json::exception&) {
                throw InputError(place +
                                 ": a field that it needs is missing or is of another kind; export "
                                 "it again.");
            }
        }
    }
}

}  // namespace scb::scenes
