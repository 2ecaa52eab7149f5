#include "scenes/meshes/mesh_answer.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace scb::scenes {
namespace {

// Twice the limits of assimp_mesh, and more than any sentence and any names.
constexpr std::uint64_t most_values = std::uint64_t{1} << 29,
                        most_characters = std::uint64_t{1} << 20;

/// Makes a received text safe for people to read.
void make_plain(std::string& text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
}

using Read = std::function<bool(std::span<std::byte>)>;

template <class T>
bool receive(const Read& read, T& values, std::uint64_t count, std::uint64_t most) {
    if (count > most) return false;
    constexpr std::uint64_t block = std::uint64_t{1} << 16, believed = std::uint64_t{1} << 20;
    values.reserve(std::min(count, believed));
    while (values.size() < count) {
        const std::size_t before = values.size();
        values.resize(before + std::min(block, count - before));
        if (!read(std::as_writable_bytes(std::span(values).subspan(before)))) return false;
    }
    return true;
}

}  // namespace

std::optional<ReceivedAnswer> receive_answer(const Read& read) {
    MeshAnswer answer;
    if (!read(std::as_writable_bytes(std::span(&answer, 1))) || answer.kind > MeshAnswer::failure)
        return std::nullopt;
    ReceivedAnswer received{static_cast<MeshAnswer::Kind>(answer.kind)};
    if (answer.kind != MeshAnswer::mesh) {
        if (!receive(read, received.sentence, answer.first, most_characters)) return std::nullopt;
        make_plain(received.sentence);
        return received;
    }
    std::string names;
    if (!receive(read, received.mesh.vertices, answer.first, most_values) ||
        !receive(read, received.mesh.triangles, answer.second, most_values) ||
        !receive(read, names, answer.third, most_characters))
        return std::nullopt;
    bool is_file = true;
    for (std::size_t at = 0; at < names.size();) {
        std::string name = names.c_str() + at;
        at += name.size() + 1;
        if (name.empty()) {
            is_file = false;
        } else if (is_file) {
            received.side_files.push_back(std::move(name));
        } else {
            make_plain(name);
            received.left_out.push_back(std::move(name));
        }
    }
    return received;
}

}  // namespace scb::scenes
