#include "scenes/meshes/mesh_answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace scb::scenes {
namespace {

template <class T>
std::string bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// What is received of these bytes, behind which only zeros come.
std::optional<ReceivedAnswer> received(const MeshAnswer& answer, const std::string& rest) {
    const std::string bytes = bytes_of(std::span(&answer, 1)) + rest;
    std::size_t at = 0;
    return receive_answer([&](std::span<std::byte> into) {
        std::fill(into.begin(), into.end(), std::byte{0});
        const std::size_t there = std::min(into.size(), bytes.size() - at);
        std::memcpy(into.data(), bytes.data() + at, there);
        at += there;
        return true;
    });
}

TEST(MeshAnswer, OfAMeshHasItsVerticesTrianglesAndSideFiles) {
    // More than one block of each.
    Mesh mesh;
    for (std::uint32_t i = 0; i < 70'000; ++i) {
        mesh.vertices.emplace_back(i, -1.0 * i, 0.5);
        mesh.triangles.push_back({i, i / 2, i / 3});
    }
    const std::string names("a.bin\0below/b.bin\0\0skins\0", 25);
    const auto answer =
        received({MeshAnswer::mesh, mesh.vertices.size(), mesh.triangles.size(), names.size()},
                 bytes_of(std::span<const Vec3>(mesh.vertices)) +
                     bytes_of(std::span<const Triangle>(mesh.triangles)) + names);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->mesh.vertices, mesh.vertices);
    EXPECT_EQ(answer->mesh.triangles, mesh.triangles);
    EXPECT_EQ(answer->side_files, (std::vector<std::string>{"a.bin", "below/b.bin"}));
    EXPECT_EQ(answer->left_out, (std::vector<std::string>{"skins"}));
}

TEST(MeshAnswer, OfAReaderThatIsTakenOverControlsNoTerminal) {
    const std::string sentence = "not\nthis\x1b[2J\x7f.";
    const auto answer = received({MeshAnswer::refusal, sentence.size()}, sentence);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->sentence, "not this [2J .");
}

TEST(MeshAnswer, OfMoreThanCanBeIsNone) {
    constexpr std::uint64_t most = std::uint64_t{1} << 20;
    EXPECT_TRUE(received({MeshAnswer::refusal, most}, ""));
    EXPECT_FALSE(received({MeshAnswer::refusal, most + 1}, ""));
    EXPECT_FALSE(received({MeshAnswer::mesh, 0, 0, most + 1}, ""));
    EXPECT_FALSE(received({MeshAnswer::failure + 1}, ""));
}

}  // namespace
}  // namespace scb::scenes
