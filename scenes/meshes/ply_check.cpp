#include "scenes/meshes/ply_check.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "core/base/text_format.h"
#include "scb/error.h"
#include "scenes/text/tokens.h"

namespace scb::scenes {
namespace {

enum class Encoding { text, little_endian, big_endian };

struct NumberType {
    std::size_t size = 0;
    bool is_float = false, is_signed = false;
};

struct Property {
    std::string name;
    NumberType type;
    std::optional<NumberType> list_length;  ///< set where the property is a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
    std::size_t size = 0;  ///< bytes up to the first element
};

std::optional<NumberType> type_of(std::string_view word) {
    struct Row {
        std::string_view word, other;
        NumberType type;
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

/// Whether the words after an unknown keyword read as those of an element or a property: without
/// that line the rest of the file would be misread. Other lines are remarks, which writers are
/// known to leave without the word comment.
bool looks_like_declaration(Words words) {
    const std::string_view second = words.next(), third = words.next();
    const bool is_count = !third.empty() && words.next().empty() &&
                          third.find_first_not_of("0123456789") == std::string_view::npos;
    return second == "list" || type_of(second) || is_count;
}

Header read_header(std::string_view bytes, const std::string& name) {
    Header header;
    bool has_format = false;
    std::size_t at = 0;
    for (std::size_t line_number = 1;; ++line_number) {
        const auto fail = [&](const std::string& reason) {
            throw InputError(name + ": header line " + std::to_string(line_number) + ": " + reason +
                             "; repair the header.");
        };
        const std::size_t end = bytes.find('\n', at);
        if (end == std::string_view::npos) fail("the file ends before end_header");
        const std::string_view line = bytes.substr(at, end - at);
        at = end + 1;
        Words words{line};
        const std::string_view key = words.next();
        if (line_number == 1) {
            if (key != "ply" && key != "PLY") fail("a PLY file starts with the line ply");
            continue;
        }
        if (key == "end_header") break;
        if (key == "format") {
            const std::string_view encoding = words.next();
            has_format = true;
            if (encoding == "ascii")
                header.encoding = Encoding::text;
            else if (encoding == "binary_little_endian")
                header.encoding = Encoding::little_endian;
            else if (encoding == "binary_big_endian")
                header.encoding = Encoding::big_endian;
            else
                fail("the format must be ascii, binary_little_endian or binary_big_endian");
        } else if (key == "element") {
            Element element{std::string(words.next()), 0, {}};
            const std::string_view count = words.next();
            const auto parsed =
                std::from_chars(count.data(), count.data() + count.size(), element.count);
            if (parsed.ec != std::errc{} || parsed.ptr != count.data() + count.size() ||
                count.empty())
                fail("element " + excerpt(element.name) + " needs a count, a whole number from 0");
            header.elements.push_back(std::move(element));
        } else if (key == "property") {
            if (header.elements.empty()) fail("a property stands before the first element");
            Property property;
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
            header.elements.back().properties.push_back(std::move(property));
        } else if (key != "comment" && key != "obj_info" && looks_like_declaration(words)) {
            fail("\"" + excerpt(key) + "\" is not a PLY keyword");
        }
    }
    if (!has_format) throw InputError(name + ": the header has no format line; repair the header.");
    header.size = at;
    return header;
}

/// Reads the values after the header one by one, whatever the encoding. `ok` turns false at the end
/// of the file or where a word is not a number.
struct Values {
    Encoding encoding;
    std::string_view bytes;
    Words words;
    bool ok = true;

    double binary(const NumberType& type) {
        if (bytes.size() < type.size) {
            ok = false;
            return 0;
        }
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.size; ++i) {
            const std::size_t from = encoding == Encoding::big_endian ? type.size - 1 - i : i;
            bits |= std::uint64_t{static_cast<unsigned char>(bytes[from])} << (8 * i);
        }
        bytes.remove_prefix(type.size);
        if (type.is_float && type.size == 4)
            return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        if (type.is_float) return std::bit_cast<double>(bits);
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
        if (type.is_signed)
            return static_cast<double>(static_cast<std::int64_t>((bits ^ sign) - sign));
        return static_cast<double>(bits);
    }

    double next(const NumberType& type) {
        if (encoding != Encoding::text) return binary(type);
        const std::optional<double> number = number_in(words.next());
        if (!number) ok = false;
        return number.value_or(0);
    }

    /// Steps over values that nobody looks at.
    void skip(const NumberType& type, std::uint64_t count) {
        if (encoding == Encoding::text) {
            for (std::uint64_t i = 0; i < count && ok; ++i) next(type);
        } else if (count > bytes.size() / type.size) {
            ok = false;
        } else {
            bytes.remove_prefix(count * type.size);
        }
    }
};

bool names_vertices(const Element& element, const Property& property) {
    return element.name == "face" &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

void check_element(Values& values, const Element& element, std::uint64_t vertices,
                   const std::string& name) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
        const auto place = [&] {
            return name + ": " + excerpt(element.name) + " " + std::to_string(i);
        };
        for (const Property& property : element.properties) {
            if (!property.list_length) {
                values.skip(property.type, 1);
            } else {
                const double length = values.next(*property.list_length);
                if (values.ok &&
                    !(length >= 0 && length == std::floor(length) && length <= 4294967295.0))
                    throw InputError(
                        place() +
                        " has a list with a length that is not a whole number from 0; repair it.");
                const auto count = values.ok ? static_cast<std::uint64_t>(length) : 0;
                if (!names_vertices(element, property)) {
                    values.skip(property.type, count);
                } else {
                    for (std::uint64_t k = 0; k < count && values.ok; ++k) {
                        const double index = values.next(property.type);
                        if (values.ok && !(index >= 0 && index < static_cast<double>(vertices) &&
                                           index == std::floor(index)))
                            throw InputError(place() + " names vertex " + exact_number(index) +
                                             ", but there are " + std::to_string(vertices) +
                                             " vertices, numbered from 0; repair the index.");
                    }
                }
            }
            if (!values.ok)
                throw InputError(place() + " of the " + std::to_string(element.count) +
                                 " that the header declares is missing or is not made of numbers; "
                                 "the file is cut off "
                                 "or its header is wrong, so get it again.");
        }
    }
}

}  // namespace

void check_ply(std::string_view bytes, const std::string& name) {
    const Header header = read_header(bytes, name);
    std::uint64_t vertices = 0;
    bool has_faces = false;
    for (const Element& element : header.elements) {
        // Without properties an element takes no room, and its count would be believed.
        if (element.properties.empty() && element.count > 0)
            throw InputError(name + ": the header declares element " + excerpt(element.name) +
                             " without any property; repair the header.");
        if (element.name == "vertex") {
            vertices = element.count;
            for (const char* axis : {"x", "y", "z"}) {
                bool found = false;
                for (const Property& property : element.properties)
                    found = found || (property.name == axis && !property.list_length);
                if (!found)
                    throw InputError(name + ": the header's vertex element has no property " +
                                     axis + "; add it.");
            }
        }
        has_faces = has_faces ||
                    (element.count > 0 && (element.name == "face" || element.name == "tristrips"));
    }
    if (vertices == 0 || !has_faces)
        throw InputError(name +
                         ": the mesh has no triangles; give a surface, not points or lines.");
    const std::string_view rest = bytes.substr(header.size);
    Values values{header.encoding, rest, Words{rest}};
    for (const Element& element : header.elements) check_element(values, element, vertices, name);
}

}  // namespace scb::scenes
