#include "scenes/meshes/off_check.h"

#include <charconv>
#include <cstdint>
#include <optional>

#include "scb/error.h"
#include "scenes/text/tokens.h"

namespace scb::scenes {
namespace {

/// The lines that hold something besides a comment.
struct Lines {
    std::string_view rest;

    std::string_view next() {
        while (!rest.empty()) {
            const std::size_t end = rest.find('\n');
            std::string_view line = rest.substr(0, end);
            rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
            line = line.substr(0, line.find('#'));
            if (!Words{line}.next().empty()) return line;
        }
        return {};
    }
};

/// Digits alone: assimp reads no other numbers here.
std::optional<std::uint32_t> whole_in(std::string_view word) {
    std::uint32_t number = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
    if (parsed.ec != std::errc{} || parsed.ptr != word.data() + word.size()) return std::nullopt;
    return number;
}

}  // namespace

void check_off(std::string_view bytes, const std::string& name) {
    Lines lines{bytes};
    std::string_view line = lines.next();
    Words first{line};
    const std::string_view magic = first.next();
    // The word may be missing.
    const bool has_word = magic.ends_with("OFF");
    if ((!has_word && !number_in(magic)) || first.next() == "BINARY") return;
    // An nOFF file states the dimension of its space on a line of its own.
    if (magic.find('n') != std::string_view::npos) lines.next();
    Words counts{has_word ? line.substr(line.find(magic) + magic.size()) : line};
    if (Words{counts}.next().empty()) counts = Words{lines.next()};
    const auto declared_vertices = whole_in(counts.next()),
               declared_faces = whole_in(counts.next());
    if (!declared_vertices || !declared_faces)
        throw InputError(
            name +
            ": the numbers of vertices and faces do not follow OFF; repair the first lines.");

    const std::uint32_t vertices = *declared_vertices, faces = *declared_faces;
    if (vertices == 0 || faces == 0)
        throw InputError(name +
                         ": the mesh has no triangles; give a surface, not points or lines.");

    const auto missing = [&](const char* what, std::uint32_t i, std::uint32_t count) {
        throw InputError(name + ": " + what + " " + std::to_string(i) + " of the " +
                         std::to_string(count) +
                         " that are declared is missing or broken; the file is cut off or its "
                         "counts are wrong, so "
                         "get it again.");
    };
    for (std::uint32_t i = 0; i < vertices; ++i) {
        Words words{lines.next()};
        for (int axis = 0; axis < 3; ++axis)
            if (!number_in(words.next())) missing("vertex", i, vertices);
    }
    for (std::uint32_t i = 0; i < faces; ++i) {
        Words words{lines.next()};
        const auto corners = whole_in(words.next());
        if (!corners) missing("face", i, faces);
        for (std::uint32_t k = 0; k < *corners; ++k) {
            const std::string_view word = words.next();
            const auto index = whole_in(word);
            if (!index && !number_in(word)) missing("face", i, faces);
            if (!index || *index >= vertices)
                throw InputError(name + ": face " + std::to_string(i) + " names vertex " +
                                 excerpt(word) + ", but there are " + std::to_string(vertices) +
                                 " vertices, numbered from 0; repair the index.");
        }
    }
}

}  // namespace scb::scenes
