#include "scenes/meshes/off_mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/platform/file_bytes.h"
#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/polygon.h"

namespace scb::scenes {
namespace {

/// The words of a text, without its comments.
class OffWords {
  public:
    explicit OffWords(std::string_view text) : rest_(text) {}

    /// The next word, on this line or a later one; empty at the end.
    std::string_view next() {
        while (Words{line_}.next().empty() && !rest_.empty()) next_line();
        return next_on_line();
    }
    /// The next word of this line; empty at its end.
    std::string_view next_on_line() {
        Words words{line_};
        const std::string_view word = words.next();
        line_ = words.rest;
        return word;
    }
    /// Skips the rest of this line; returns the number of its words.
    std::size_t skip_line() {
        std::size_t words = 0;
        while (!next_on_line().empty()) ++words;
        return words;
    }
    /// The only word of the next line with words; if it has several, takes nothing and returns an
    /// empty word.
    std::string_view next_alone() {
        OffWords ahead = *this;
        const std::string_view word = ahead.next();
        if (!ahead.next_on_line().empty()) return {};
        *this = ahead;
        return word;
    }

  private:
    void next_line() {
        const std::size_t end = rest_.find_first_of("\r\n");
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
        line_ = line_.substr(0, line_.find('#'));
    }

    std::string_view line_, rest_;
};

/// Digits alone.
std::optional<std::uint32_t> whole_in(std::string_view word) {
    std::uint32_t number = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
    if (parsed.ec != std::errc{} || parsed.ptr != word.data() + word.size()) return std::nullopt;
    return number;
}

/// The first word of an OFF file.
struct Magic {
    bool more = false;         ///< vertices have normals, colors or texture coordinates
    bool homogeneous = false;  ///< vertices have a fourth number
    bool says_dimension = false;
};

std::optional<Magic> magic_in(std::string_view word) {
    Magic magic;
    const auto take = [&](std::string_view start) {
        if (!word.starts_with(start)) return false;
        word.remove_prefix(start.size());
        return true;
    };
    for (const char* part : {"ST", "C", "N"}) magic.more = take(part) || magic.more;
    magic.homogeneous = take("4");
    magic.says_dimension = take("n");
    if (word != "OFF") return std::nullopt;
    return magic;
}

class OffReader {
  public:
    OffReader(std::string_view text, const std::string& name)
        : size_(text.size()), words_(text), name_(name) {}

    Mesh read() {
        read_header();
        // Each vertex takes at least two bytes.
        mesh_.vertices.reserve(std::min<std::size_t>(vertices_, size_ / 2));
        mesh_.triangles.reserve(std::min<std::size_t>(faces_, size_ / 2));
        for (std::uint32_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (std::uint32_t i = 0; i < faces_; ++i) read_face(i);
        if (mesh_.triangles.empty()) refuse_no_triangles();
        return std::move(mesh_);
    }

  private:
    void read_header() {
        std::string_view word = words_.next();
        if (const std::optional<Magic> magic = magic_in(word)) {
            magic_ = *magic;
            word = words_.next();
            if (word == "BINARY")
                throw InputError(name_ +
                                 ": binary OFF is not read; export a text OFF, PLY or STL.");
            if (magic->says_dimension) {
                const std::optional<std::uint32_t> dimension = whole_in(word);
                if (!dimension || *dimension < 1 || *dimension > 3)
                    throw InputError(name_ + ": its space has the dimension " + excerpt(word) +
                                     ", and 1 to 3 are read; repair the first lines.");
                dimension_ = *dimension;
                word = words_.next();
            }
        }
        const std::optional<std::uint32_t> vertices = whole_in(word),
                                           faces = whole_in(words_.next());
        if (!vertices || !faces)
            throw InputError(
                name_ +
                ": the numbers of vertices and faces do not follow OFF; repair the first lines.");
        vertices_ = *vertices;
        faces_ = *faces;
        if (vertices_ == 0 || faces_ == 0) refuse_no_triangles();
        // The number of edges, which may be missing.
        if (words_.skip_line() == 0) words_.next_alone();
    }

    void read_vertex(std::uint32_t i) {
        std::array<double, 3> at{};
        const auto number = [&] {
            const std::optional<double> value = number_in(words_.next());
            if (!value) refuse_missing("vertex", i, vertices_);
            return *value;
        };
        for (std::uint32_t axis = 0; axis < dimension_; ++axis) at[axis] = number();
        const double weight = magic_.homogeneous ? number() : 1;
        for (double& coordinate : at) coordinate /= weight;
        // A color has three or four numbers, or is an index.
        const std::size_t more = words_.skip_line();
        if (!magic_.more && (more == 2 || more > 4))
            throw InputError(name_ + ": the line of vertex " + std::to_string(i) + " has " +
                             std::to_string(more) +
                             " words after the coordinates, but a color has 1, 3 or 4; write each "
                             "vertex on a line of its own.");
        mesh_.vertices.emplace_back(at[0], at[1], at[2]);
    }

    void read_face(std::uint32_t i) {
        const std::optional<std::uint32_t> corners = whole_in(words_.next());
        if (!corners) refuse_missing("face", i, faces_);
        corners_.clear();
        for (std::uint32_t k = 0; k < *corners; ++k) {
            const std::string_view word = words_.next();
            const std::optional<std::uint32_t> index = whole_in(word);
            if (!index && !number_in(word)) refuse_missing("face", i, faces_);
            if (!index || *index >= vertices_)
                throw InputError(name_ + ": face " + std::to_string(i) + " names vertex " +
                                 excerpt(word) + ", but there are " + std::to_string(vertices_) +
                                 " vertices, numbered from 0; repair the index.");
            corners_.push_back(*index);
        }
        words_.skip_line();
        if (corners_.size() == 3)  // for speed: no name is made
            mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
        else
            cutter_.append(corners_, mesh_.vertices, name_ + ": face " + std::to_string(i),
                           mesh_.triangles);
    }

    [[noreturn]] void refuse_missing(const char* what, std::uint32_t i, std::uint32_t count) const {
        throw InputError(name_ + ": " + what + " " + std::to_string(i) + " of the " +
                         std::to_string(count) +
                         " that are declared is missing or broken; the file is cut off or its "
                         "counts are wrong, so get it again.");
    }
    [[noreturn]] void refuse_no_triangles() const {
        throw InputError(name_ +
                         ": the mesh has no triangles; give a surface, not points or lines.");
    }

    std::size_t size_;
    OffWords words_;
    const std::string& name_;
    Magic magic_;
    std::uint32_t dimension_ = 3, vertices_ = 0, faces_ = 0;
    Mesh mesh_;
    PolygonCutter cutter_;
    std::vector<std::uint32_t> corners_;
};

}  // namespace

bool is_off(std::string_view start) { return magic_in(OffWords(start).next()).has_value(); }

Mesh off_mesh(const std::string& path) {
    const std::string text = file_bytes(path);
    return OffReader(text, path).read();
}

}  // namespace scb::scenes
