#pragma once

#include <cstring>
#include <string>

#include "scb/mesh.h"
#include "tests/scenes/support.h"

namespace scb::scenes {

/// Four corners and six triangles: a tetrahedron, one triangle again, and one that repeats a
/// corner.
inline const Mesh sample_mesh = {
    {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}},
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}, {1, 1, 2}}};

/// Compares triangles in file order, corner by corner. The reader may repeat vertices.
inline void expect_same_triangles(const Mesh& mesh, const Vec3& offset = Vec3::Zero(),
                                  double scale = 1) {
    ASSERT_EQ(mesh.triangles.size(), sample_mesh.triangles.size());
    for (std::size_t t = 0; t < sample_mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.vertices[mesh.triangles[t][k]],
                      Vec3(scale * sample_mesh.vertices[sample_mesh.triangles[t][k]] + offset))
                << "triangle " << t << " corner " << k;
}

/// The bytes of a number.
template <class T>
std::string raw(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

/// The sample's corners, each as three floats.
inline std::string corner_floats() {
    std::string buffer;
    for (const Vec3& v : sample_mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) buffer += raw(static_cast<float>(v[axis]));
    return buffer;
}

inline std::string base64(const std::string& bytes) {
    const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// The sample as glTF. `nodes` is the JSON of the list of nodes; the first one is the scene's root.
inline std::string gltf(const std::string& nodes) {
    std::string buffer = corner_floats();
    const std::size_t vertex_bytes = buffer.size();
    for (const Triangle& t : sample_mesh.triangles)
        for (const std::uint32_t v : t) buffer += raw(static_cast<std::uint16_t>(v));
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": )" +
           nodes +
           R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "buffers": [{"byteLength": )" +
           std::to_string(buffer.size()) + R"(, "uri": "data:application/octet-stream;base64,)" +
           base64(buffer) +
           R"("}], "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": )" +
           std::to_string(vertex_bytes) + R"(}, {"buffer": 0, "byteOffset": )" +
           std::to_string(vertex_bytes) + R"(, "byteLength": )" +
           std::to_string(buffer.size() - vertex_bytes) +
           R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0],
              "max": [1, 2, 3]}, {"bufferView": 1, "componentType": 5123, "count": 18, "type": "SCALAR"}]})";
}

}  // namespace scb::scenes
