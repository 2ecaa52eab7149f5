#include "scenes/meshes/obj_mesh.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/platform/file_window.h"
#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/polygon.h"

namespace scb::scenes {
namespace {

constexpr std::size_t most_entries = std::size_t{1} << 28, largest_line = std::size_t{1} << 20;

/// The lines of a text; a vertex or face that ends with a backslash goes on in the next.
class ObjLines {
  public:
    explicit ObjLines(const std::string& path) : file_(path) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (file_.ahead(byte_order_mark.size()).starts_with(byte_order_mark))
            file_.skip(byte_order_mark.size());
    }

    /// Nothing after the last line. Valid until the next call.
    std::optional<std::string_view> next() {
        joined_.clear();
        for (;;) {
            const std::optional<std::string_view> part = next_part();
            if (!part) return joined_.empty() ? part : joined_;
            const bool goes_on =
                part->ends_with('\\') && is_data(joined_.empty() ? *part : joined_);
            if (!goes_on && joined_.empty()) return part;
            joined_.append(part->substr(0, part->size() - (goes_on ? 1 : 0)));
            if (!goes_on) return joined_;
            joined_ += ' ';
            if (joined_.size() > largest_line) refuse_length();
        }
    }

    /// The number of the latest line, from 1; for joined lines, of their last.
    std::uint64_t number() const { return number_; }

  private:
    /// Whether it is a line of numbers, without a comment: in names and comments a backslash is
    /// one.
    static bool is_data(std::string_view line) {
        const std::string_view keyword = Words{line}.next();
        return (keyword == "v" || keyword == "f") && line.find('#') == line.npos;
    }

    std::optional<std::string_view> next_part() {
        std::string_view ahead = file_.ahead(1);
        if (std::exchange(ended_by_return_, false) && ahead.starts_with('\n')) {
            file_.skip(1);
            ahead = file_.ahead(1);
        }
        if (ahead.empty()) return std::nullopt;
        ++number_;
        std::size_t size = ahead.find_first_of("\r\n");
        if (size == ahead.npos) {
            ahead = file_.ahead(largest_line);
            size = ahead.find_first_of("\r\n");
        }
        if (size == ahead.npos && ahead.size() >= largest_line) refuse_length();
        if (size == ahead.npos) {
            file_.skip(ahead.size());
            return ahead;
        }
        ended_by_return_ = ahead[size] == '\r';
        file_.skip(size + 1);
        return ahead.substr(0, size);
    }

    [[noreturn]] void refuse_length() const {
        throw InputError(file_.name() + ": line " + std::to_string(number_) +
                         " has more than 1 MiB, so this is no text; give an OBJ file.");
    }

    FileWindow file_;
    std::uint64_t number_ = 0;
    bool ended_by_return_ = false;
    std::string joined_;
};

class ObjReader {
  public:
    explicit ObjReader(const std::string& path) : path_(path), lines_(path) {}

    Mesh read() {
        while (const std::optional<std::string_view> line = lines_.next()) {
            Words words{line->substr(0, line->find('#'))};
            const std::string_view keyword = words.next();
            if (keyword == "v")
                read_vertex(words);
            else if (keyword == "f")
                read_face(words);
        }
        append_faces();
        if (mesh_.triangles.empty())
            throw InputError(path_ +
                             ": the mesh has no triangles; give a surface, not points or lines.");
        return std::move(mesh_);
    }

  private:
    /// The polygons wait until all vertices are known.
    struct Face {
        std::size_t end;  ///< of its corners
        std::uint64_t line;
    };

    std::string place(std::uint64_t line) const { return path_ + ": line " + std::to_string(line); }
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(place(lines_.number()) + ": " + sentence);
    }
    void check_count(std::size_t count) const {
        if (count >= most_entries)
            refuse("the mesh has more than " + std::to_string(most_entries) +
                   " vertices or corners of faces; give a smaller mesh.");
    }

    void read_vertex(Words words) {
        check_count(mesh_.vertices.size());
        std::array<double, 3> numbers{};
        std::size_t count = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++count) {
            const std::optional<double> number = number_in(word);
            if (!number)
                refuse("expected a coordinate, found \"" + excerpt(word) + "\"; repair it.");
            if (count < numbers.size()) numbers[count] = *number;
        }
        if (count != 3 && count != 4 && count != 6 && count != 7)
            refuse("a vertex has 3 coordinates, which a weight and a color may follow, not " +
                   std::to_string(count) + (count == 1 ? " number" : " numbers") +
                   "; repair the line.");
        mesh_.vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
    }

    void read_face(Words words) {
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            check_count(corners_.size());
            corners_.push_back(corner(word));
        }
        // Faces without a corner would take more memory than their files.
        if (faces_.empty() ? !corners_.empty() : corners_.size() > faces_.back().end)
            faces_.push_back({corners_.size(), lines_.number()});
    }

    /// The number before the first slash, from 1 or from -1, as an index from 0.
    std::uint32_t corner(std::string_view word) const {
        const char* const end = word.data() + word.size();
        std::int64_t number = 0;
        const auto parsed = std::from_chars(word.data(), end, number);
        if (parsed.ec != std::errc{} || (parsed.ptr != end && *parsed.ptr != '/'))
            refuse("expected a corner such as 1, 1/2 or 1/2/3, found \"" + excerpt(word) +
                   "\"; repair it.");
        const auto so_far = static_cast<std::int64_t>(mesh_.vertices.size());
        const std::int64_t index = number > 0 ? number - 1 : so_far + number;
        if (number == 0 || index < 0 || index >= static_cast<std::int64_t>(most_entries))
            refuse("names vertex " + std::to_string(number) + " after " + std::to_string(so_far) +
                   " vertices, numbered from 1 and backwards from -1; repair the index.");
        return static_cast<std::uint32_t>(index);
    }

    void append_faces() {
        mesh_.triangles.reserve(faces_.size());
        PolygonCutter cutter;
        std::size_t start = 0;
        for (const Face& face : faces_) {
            const std::span<const std::uint32_t> corners(corners_.data() + start, face.end - start);
            start = face.end;
            for (const std::uint32_t corner : corners)
                if (corner >= mesh_.vertices.size())
                    throw InputError(place(face.line) + ": names vertex " +
                                     std::to_string(corner + 1) + ", but there are " +
                                     std::to_string(mesh_.vertices.size()) +
                                     " vertices, numbered from 1; repair the index.");
            cutter.append(corners, mesh_.vertices, place(face.line), mesh_.triangles);
        }
    }

    const std::string& path_;
    ObjLines lines_;
    Mesh mesh_;
    std::vector<std::uint32_t> corners_;
    std::vector<Face> faces_;
};

}  // namespace

Mesh obj_mesh(const std::string& path) { return ObjReader(path).read(); }

}  // namespace scb::scenes
