#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scb/mesh.h"

namespace scb::scenes {

/// What isolated_mesh has the program do: `scb read-mesh PATH`. It is no command for users.
inline constexpr const char* mesh_reader_command = "read-mesh";

/// The descriptor of that process which its answer goes to: the greeting once it is ready, then an
/// answer.
inline constexpr int mesh_answer_descriptor = 3;

using MeshGreeting = std::array<char, 16>;
inline constexpr MeshGreeting mesh_greeting = {'s', 'c', 'b', ' ', 'm', 'e', 's', 'h',
                                               ' ', '5', 0,   0,   0,   0,   0,   0};

/// How an answer begins. The vertices and the triangles of a mesh follow, as they lie in memory,
/// and the names of its side files, an empty name, and what of the file is left out, each with a
/// zero behind it; or a sentence.
struct MeshAnswer {
    enum Kind : std::uint64_t { mesh, refusal, unconfined, limited, failure };
    std::uint64_t kind = failure;
    std::uint64_t first = 0;   ///< how many vertices, or characters
    std::uint64_t second = 0;  ///< how many triangles
    std::uint64_t third = 0;   ///< how many characters of names
};
static_assert(sizeof(MeshAnswer) == 32 && sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

/// An answer that came whole. What is for people to read is on one line, of plain characters.
struct ReceivedAnswer {
    MeshAnswer::Kind kind = MeshAnswer::failure;
    Mesh mesh{};
    std::vector<std::string> side_files{};
    std::vector<std::string> left_out{};
    std::string sentence{};
};

/// Receives an answer from a process of which nothing is believed: sizes are bounded, and memory is
/// written only where something comes. `read` fills the bytes, or returns false where there are no
/// more. Nothing where the answer is cut short or is none. Vertices and indices are not checked.
std::optional<ReceivedAnswer> receive_answer(const std::function<bool(std::span<std::byte>)>& read);

}  // namespace scb::scenes
