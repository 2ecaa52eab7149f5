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

/// The command that isolated_mesh runs: `scb read-mesh PATH`. It is not for users.
inline constexpr const char* mesh_reader_command = "read-mesh";

/// The descriptor to which that process writes: the greeting once it is ready, then an answer.
inline constexpr int mesh_answer_descriptor = 3;

using MeshGreeting = std::array<char, 16>;
inline constexpr MeshGreeting mesh_greeting = {'s', 'c', 'b', ' ', 'm', 'e', 's', 'h',
                                               ' ', '5', 0,   0,   0,   0,   0,   0};

/// The begin of an answer. A mesh follows: its vertices and triangles, as in memory, the names of
/// its side files, an empty name, and the parts of the file that are left out, each with a zero
/// behind it. Or a sentence follows.
struct MeshAnswer {
    enum Kind : std::uint64_t { mesh, refusal, unconfined, limited, failure };
    std::uint64_t kind = failure;
    std::uint64_t first = 0;   ///< the number of vertices, or of characters
    std::uint64_t second = 0;  ///< the number of triangles
    std::uint64_t third = 0;   ///< the number of characters of names
};
static_assert(sizeof(MeshAnswer) == 32 && sizeof(Vec3) == 24 && sizeof(Triangle) == 12);

/// A complete answer. Its texts for people are on one line, of plain characters.
struct ReceivedAnswer {
    MeshAnswer::Kind kind = MeshAnswer::failure;
    Mesh mesh{};
    std::vector<std::string> side_files{};
    std::vector<std::string> left_out{};
    std::string sentence{};
};

/// Receives an answer from an untrusted process: sizes are bounded, and memory is only written as
/// bytes arrive. `read` fills the bytes, or returns false if there are no more. Nothing if the
/// answer is incomplete or invalid. Vertices and indices are not checked.
std::optional<ReceivedAnswer> receive_answer(const std::function<bool(std::span<std::byte>)>& read);

}  // namespace scb::scenes
