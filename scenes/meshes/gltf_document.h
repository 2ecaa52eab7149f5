#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scb::scenes {

/// The two parts of a glTF file.
struct GltfParts {
    std::string_view text;    ///< the JSON
    std::string_view binary;  ///< the chunk of a .glb that follows it
};

/// A .gltf is its JSON. A .glb has a header of 12 bytes and chunks of length, type and data; the
/// first is the JSON, the second the buffer without a URI.
GltfParts gltf_parts(std::string_view bytes);

/// The path that assimp makes of a buffer's uri.
std::string gltf_path(std::string uri);

/// The document of a glTF 2 file and the bytes of its buffers, each fetched once.
struct GltfDocument {
    nlohmann::json root;
    std::string_view binary;
    std::string name;                                      ///< of the file
    std::map<std::string, std::string> files{};            ///< bytes, by uri
    std::map<std::size_t, std::string> decoded_buffers{};  ///< buffers of data uris
    std::map<std::size_t, std::string_view> fetched{};     ///< both kinds, fetched

    /// Empty if the bytes are missing. Throws json::exception if the document has no such buffer,
    /// and InputError if its base64 is damaged.
    std::string_view buffer(std::size_t index);

  private:
    std::string decoded(std::string_view text, std::size_t index) const;
};

/// A field that is an integer from 0. Throws json::exception if it is another value.
std::size_t gltf_natural(const nlohmann::json& object, const char* key, std::size_t otherwise = 0);

/// The type of an accessor's numbers.
enum GltfComponent : std::size_t {
    gltf_int8 = 5120,
    gltf_uint8 = 5121,
    gltf_int16 = 5122,
    gltf_uint16 = 5123,
    gltf_uint32 = 5125,
    gltf_float = 5126,
};

/// The bytes of an accessor's elements, `count` of `size` bytes, one every `stride` bytes.
struct GltfElements {
    std::string_view bytes;
    std::size_t size = 0, stride = 0, count = 0;

    /// Whether the last element ends within the bytes.
    bool are_there() const {
        return count == 0 || (bytes.size() >= size && (bytes.size() - size) / stride >= count - 1);
    }
};

/// `count` elements of `components` numbers each, of a buffer view. Throws json::exception if the
/// document has no such view.
GltfElements gltf_elements(GltfDocument& document, std::size_t view, std::size_t offset,
                           std::size_t component_type, std::size_t components, std::size_t count);

/// All numbers of an accessor, including sparse ones, and normalized if it says so. `place` begins
/// messages. Throws InputError if the accessor reaches beyond its bytes, is compressed, or is of
/// another type; json::exception if a field is missing.
std::vector<double> gltf_numbers(GltfDocument& document, const nlohmann::json& accessor,
                                 const std::string& type, const std::string& place);

}  // namespace scb::scenes
