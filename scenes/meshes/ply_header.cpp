#include "scenes/meshes/ply_header.h"

#include <charconv>
#include <string_view>

#include "core/platform/tokens.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

std::optional<PlyType> type_of(std::string_view word) {
    struct Row {
        std::string_view word, other;
        PlyType type;
    };
    static constexpr Row rows[] = {
        {"char", "int8", {1, false, true}},    {"uchar", "uint8", {1, false, false}},
        {"short", "int16", {2, false, true}},  {"ushort", "uint16", {2, false, false}},
        {"int", "int32", {4, false, true}},    {"uint", "uint32", {4, false, false}},
        {"float", "float32", {4, true, true}}, {"double", "float64", {8, true, true}},
    };
    for (const Row& row : rows)
        if (word == row.word || word == row.other) return row.type;
    return std::nullopt;
}

/// Whether the words after an unknown keyword look like an element or a property: if such a line
/// was ignored, the rest of the file would be misread.
bool looks_like_declaration(Words words) {
    const std::string_view second = words.next(), third = words.next();
    const bool is_count = !third.empty() && words.next().empty() &&
                          third.find_first_not_of("0123456789") == std::string_view::npos;
    return second == "list" || type_of(second) || is_count;
}

class HeaderReader {
  public:
    explicit HeaderReader(FileWindow& file) : file_(file) {}

    PlyHeader read() {
        find_line_end();
        Words first{next_line()};
        if (const std::string_view key = first.next(); key != "ply" && key != "PLY")
            fail("a PLY file starts with the line ply");
        while (true) {
            Words words{next_line()};
            const std::string_view key = words.next();
            if (key == "end_header") break;
            if (key == "format")
                read_format(words);
            else if (key == "element")
                read_element(words);
            else if (key == "property")
                read_property(words);
            else if (key != "comment" && key != "obj_info" && looks_like_declaration(words))
                fail("\"" + excerpt(key) + "\" is not a PLY keyword");
        }
        if (!has_format_)
            throw InputError(file_.name() + ": the header has no format line; repair the header.");
        return std::move(header_);
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw InputError(file_.name() + ": header line " + std::to_string(line_) + ": " + reason +
                         "; repair the header.");
    }

    void find_line_end() {
        const std::string_view start = file_.ahead(4096);
        const std::size_t at = start.find_first_of("\r\n");
        const bool alone = at != start.npos && start[at] == '\r' &&
                           (at + 1 == start.size() || start[at + 1] != '\n');
        if (alone) line_end_ = '\r';
    }

    /// Valid until the next call.
    std::string_view next_line() {
        ++line_;
        // No header is long; without a bound, an endless file would be read forever.
        constexpr std::size_t longest_line = std::size_t{1} << 16;
        constexpr int most_lines = 10'000;
        const std::string_view ahead = file_.ahead(longest_line);
        const std::size_t end = ahead.find(line_end_);
        if (end == ahead.npos) {
            if (ahead.size() < longest_line) fail("the file ends before end_header");
            fail("it is longer than " + std::to_string(longest_line) + " bytes");
        }
        if (line_ > most_lines) fail("no header has so many lines");
        file_.skip(end + 1);
        return ahead.substr(0, end);
    }

    void read_format(Words words) {
        const std::string_view encoding = words.next();
        if (has_format_) fail("there is a second format line");
        has_format_ = true;
        if (encoding == "ascii")
            header_.encoding = PlyEncoding::text;
        else if (encoding == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (encoding == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            fail("the format must be ascii, binary_little_endian or binary_big_endian");
    }

    void read_element(Words words) {
        PlyElement element{std::string(words.next()), 0, {}};
        const std::string_view count = words.next();
        const char* const end = count.data() + count.size();
        const auto parsed = std::from_chars(count.data(), end, element.count);
        if (count.empty() || parsed.ec != std::errc{} || parsed.ptr != end)
            fail("element " + excerpt(element.name) + " needs a count, a whole number from 0");
        header_.elements.push_back(std::move(element));
    }

    void read_property(Words words) {
        if (header_.elements.empty()) fail("a property stands before the first element");
        PlyProperty property;
        std::string_view word = words.next();
        if (word == "list") {
            property.list_length = type_of(words.next());
            if (!property.list_length || property.list_length->is_float)
                fail("the length of a list needs a whole-number type, such as uchar");
            word = words.next();
        }
        const auto type = type_of(word);
        if (!type) fail("the type \"" + excerpt(word) + "\" is not a PLY type");
        property.type = *type;
        property.name = words.next();
        header_.elements.back().properties.push_back(std::move(property));
    }

    FileWindow& file_;
    PlyHeader header_;
    bool has_format_ = false;
    char line_end_ = '\n';
    int line_ = 0;
};

}  // namespace

PlyHeader read_ply_header(FileWindow& file) { return HeaderReader(file).read(); }

}  // namespace scb::scenes
