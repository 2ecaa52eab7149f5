#include "scenes/meshes/off_check.h"

#include <cmath>
#include <cstdint>

#include "core/base/text_format.h"
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

bool is_whole(double number, double low, double high) {
    return number >= low && number <= high && number == std::floor(number);
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
    const double vertices = number_in(counts.next()).value_or(-1),
                 faces = number_in(counts.next()).value_or(-1);
    if (!is_whole(vertices, 0, 4294967295.0) || !is_whole(faces, 0, 4294967295.0))
        throw InputError(
            name +
            ": the numbers of vertices and faces do not follow OFF; repair the first lines.");

    if (vertices == 0 || faces == 0)
        throw InputError(name +
                         ": the mesh has no triangles; give a surface, not points or lines.");

    const auto missing = [&](const char* what, std::uint64_t i, double count) {
        throw InputError(name + ": " + what + " " + std::to_string(i) + " of the " +
                         std::to_string(static_cast<std::uint64_t>(count)) +
                         " that are declared is missing or broken; the file is cut off or its "
                         "counts are wrong, so "
                         "get it again.");
    };
    for (std::uint64_t i = 0; static_cast<double>(i) < vertices; ++i) {
        Words words{lines.next()};
        for (int axis = 0; axis < 3; ++axis)
            if (!number_in(words.next())) missing("vertex", i, vertices);
    }
    for (std::uint64_t i = 0; static_cast<double>(i) < faces; ++i) {
        Words words{lines.next()};
        const double corners = number_in(words.next()).value_or(-1);
        if (!is_whole(corners, 0, 4294967295.0)) missing("face", i, faces);
        for (std::uint64_t k = 0; static_cast<double>(k) < corners; ++k) {
            const auto index = number_in(words.next());
            if (!index) missing("face", i, faces);
            if (!is_whole(*index, 0, vertices - 1))
                throw InputError(name + ": face " + std::to_string(i) + " names vertex " +
                                 exact_number(*index) + ", but there are " +
                                 std::to_string(static_cast<std::uint64_t>(vertices)) +
                                 " vertices, numbered from 0; repair the index.");
        }
    }
}

}  // namespace scb::scenes
