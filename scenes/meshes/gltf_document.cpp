#include "scenes/meshes/gltf_document.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/platform/file_bytes.h"
#include "scb/error.h"
#include "scenes/meshes/confinement.h"
#include "scenes/meshes/little_endian.h"
#include "scenes/meshes/mesh_folder.h"

namespace scb::scenes {
namespace {

using nlohmann::json;

/// Nothing if a letter is not of the code.
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

/// 0 if there is no such type.
std::size_t size_of_component(std::size_t type) {
    switch (type) {
        case gltf_int8:
        case gltf_uint8:
            return 1;
        case gltf_int16:
        case gltf_uint16:
            return 2;
        case gltf_uint32:
        case gltf_float:
            return 4;
        default:
            return 0;
    }
}

/// Normalized by glTF 2.0, section 3.6.2.2.
double number_at(std::string_view bytes, std::size_t at, std::size_t type, bool normalized) {
    const std::uint32_t bits = little_endian(bytes, at, size_of_component(type));
    const auto scaled = [&](double value, double most) {
        return normalized ? std::max(value / most, -1.0) : value;
    };
    switch (type) {
        case gltf_int8:
            return scaled(static_cast<std::int8_t>(bits), 127);
        case gltf_uint8:
            return scaled(bits, 255);
        case gltf_int16:
            return scaled(static_cast<std::int16_t>(bits), 32767);
        case gltf_uint16:
            return scaled(bits, 65535);
        case gltf_float:
            return std::bit_cast<float>(bits);
        default:
            return bits;
    }
}

constexpr std::size_t most_elements = std::size_t{1} << 28;

}  // namespace

GltfParts gltf_parts(std::string_view bytes) {
    if (bytes.substr(0, 4) != "glTF") return {bytes, {}};
    if (bytes.size() < 20) return {};
    const std::size_t length = little_endian(bytes, 12, 4);
    GltfParts parts{bytes.substr(20, length), {}};
    // Some writers pad with zeros instead of spaces.
    parts.text = parts.text.substr(0, parts.text.find_last_not_of('\0') + 1);
    if (bytes.size() < 28 || length > bytes.size() - 28) return parts;
    parts.binary = bytes.substr(28 + length, little_endian(bytes, 20 + length, 4));
    return parts;
}

std::string gltf_path(std::string uri) {
    if (!uri.starts_with("data:")) std::replace(uri.begin(), uri.end(), '\\', '/');
    return uri;
}

std::string_view GltfDocument::buffer(std::size_t index) {
    const json& entry = root.at("buffers").at(index);
    if (!entry.contains("uri")) return binary;
    const auto found = fetched.find(index);
    if (found != fetched.end()) return found->second;
    const auto& uri = entry.at("uri").get_ref<const std::string&>();
    std::string_view& bytes = fetched[index];
    constexpr std::string_view mark = ";base64,";
    const std::size_t data = uri.find(mark);
    if (!uri.starts_with("data:")) {
        // Once for all buffers that name it.
        const auto [file, is_new] = files.try_emplace(gltf_path(uri));
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

std::string GltfDocument::decoded(std::string_view text, std::size_t index) const {
    std::optional<std::string> bytes = decode_base64(text);
    if (!bytes)
        throw InputError(name + ": buffer " + std::to_string(index) +
                         ": its base64 is damaged; export the file again.");
    return std::move(*bytes);
}

std::size_t gltf_natural(const json& object, const char* key, std::size_t otherwise) {
    return object.contains(key) ? object.at(key).get_ref<const json::number_unsigned_t&>()
                                : otherwise;
}

GltfElements gltf_elements(GltfDocument& document, std::size_t view, std::size_t offset,
                           std::size_t component_type, std::size_t components, std::size_t count) {
    const json& entry = document.root.at("bufferViews").at(view);
    GltfElements elements;
    elements.size = size_of_component(component_type) * components;
    elements.count = count;
    const std::size_t stride = gltf_natural(entry, "byteStride");
    elements.stride = stride == 0 ? elements.size : stride;
    const std::string_view buffer = document.buffer(gltf_natural(entry, "buffer"));
    const std::size_t view_start = std::min(gltf_natural(entry, "byteOffset"), buffer.size());
    const std::string_view view_bytes =
        buffer.substr(view_start, gltf_natural(entry, "byteLength"));
    elements.bytes = view_bytes.substr(std::min(offset, view_bytes.size()));
    return elements;
}

std::vector<double> gltf_numbers(GltfDocument& document, const json& accessor,
                                 const std::string& type, const std::string& place) {
    const std::size_t components = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
    const std::size_t component_type = gltf_natural(accessor, "componentType"),
                      count = gltf_natural(accessor, "count");
    if (accessor.at("type") != type || size_of_component(component_type) == 0 ||
        count > most_elements)
        throw InputError(place + ": an accessor has another type than " + type +
                         ", or more than 2^28 elements; export it again.");
    const bool normalized =
        accessor.contains("normalized") && accessor.at("normalized").get<bool>();
    const auto elements_of = [&](const json& owner, std::size_t kind, std::size_t numbers,
                                 std::size_t size) {
        const std::size_t view = gltf_natural(owner, "bufferView");
        const json& entry = document.root.at("bufferViews").at(view);
        if (entry.contains("extensions") &&
            entry.at("extensions").contains("EXT_meshopt_compression"))
            throw InputError(place +
                             ": its numbers are compressed by EXT_meshopt_compression, which is "
                             "not read; export it without.");
        const GltfElements elements =
            gltf_elements(document, view, gltf_natural(owner, "byteOffset"), kind, numbers, size);
        if (!elements.are_there())
            throw InputError(place + ": an accessor of " + std::to_string(size) +
                             " elements reaches beyond buffer view " + std::to_string(view) +
                             " or its buffer; repair its count, offset or stride.");
        return elements;
    };
    const auto read = [&](const GltfElements& from, std::size_t element, double* to) {
        const std::size_t size = from.size / components;
        for (std::size_t i = 0; i < components; ++i)
            to[i] =
                number_at(from.bytes, element * from.stride + i * size, component_type, normalized);
    };
    std::vector<double> numbers;
    if (accessor.contains("bufferView")) {
        const GltfElements elements = elements_of(accessor, component_type, components, count);
        numbers.resize(count * components);
        for (std::size_t e = 0; e < count; ++e) read(elements, e, &numbers[e * components]);
    } else {
        numbers.resize(count * components);
    }
    if (!accessor.contains("sparse")) return numbers;
    const json& sparse = accessor.at("sparse");
    const std::size_t changed = gltf_natural(sparse, "count");
    const std::size_t index_type = gltf_natural(sparse.at("indices"), "componentType");
    if (size_of_component(index_type) == 0 || index_type == gltf_float)
        throw InputError(place +
                         ": the indices of a sparse accessor are no whole numbers; export "
                         "it again.");
    const GltfElements indices = elements_of(sparse.at("indices"), index_type, 1, changed);
    const GltfElements values =
        elements_of(sparse.at("values"), component_type, components, changed);
    for (std::size_t i = 0; i < changed; ++i) {
        const std::size_t element = little_endian(indices.bytes, i * indices.stride, indices.size);
        if (element >= count)
            throw InputError(place + ": a sparse accessor changes element " +
                             std::to_string(element) + " of " + std::to_string(count) +
                             ", numbered from 0; repair the index.");
        read(values, i, &numbers[element * components]);
    }
    return numbers;
}

}  // namespace scb::scenes
