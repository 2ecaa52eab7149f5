#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "scb/mesh.h"

namespace scb {

/// A value inside a JSON document together with its place, so that an error can name both. It
/// refers to the document and must not outlive it.
struct JsonPlace {
    const nlohmann::json* value = nullptr;
    std::string file;  ///< the document's name for messages
    std::string path;  ///< for example `bodies[1].rotation[0].axis`; empty for the whole document

    const nlohmann::json& operator*() const { return *value; }
};

/// The deepest nesting of arrays and objects that is read.
inline constexpr int max_json_depth = 100;

/// Parses a document. Throws InputError with file, line and column if it is not JSON, has a number
/// that a double cannot hold, has an object with a field twice, which JSON readers otherwise
/// resolve silently, or is nested more than max_json_depth deep.
nlohmann::json parse_json(std::string_view text, const std::string& file);
/// The same with the fields of objects in the order of the document.
nlohmann::ordered_json parse_ordered_json(std::string_view text, const std::string& file);

/// The whole text of a file. Throws InputError if it is missing, a directory, larger than
/// `largest`, or unreadable.
std::string read_text_file(const std::string& file, std::size_t largest = std::size_t{64} << 20);

/// Throws InputError: `FILE: PATH: SENTENCE`.
[[noreturn]] void refuse(const JsonPlace& place, const std::string& sentence);

/// Throws InputError: `FILE: PATH: expected EXPECTED, found VALUE.`
[[noreturn]] void refuse_value(const JsonPlace& place, const std::string& expected);

/// Throws InputError if the value is not an object, or has a field that is not in the list.
void check_fields(const JsonPlace& place, std::initializer_list<std::string_view> known);

bool has(const JsonPlace& object, const char* field);

/// A field of an object, refused if missing; an element of an array.
JsonPlace field(const JsonPlace& object, const char* name);
JsonPlace element(const JsonPlace& array, std::size_t index);

/// The number of elements; refuses values that are not arrays.
std::size_t array_size(const JsonPlace& place, const char* expected);

/// Values of a type; refused if the value is of another type or out of range (bounds included).
double read_number(const JsonPlace& place, double low = -max_coordinate,
                   double high = max_coordinate);
std::int64_t read_integer(const JsonPlace& place, std::int64_t low, std::int64_t high);
double read_positive(const JsonPlace& place);
bool read_bool(const JsonPlace& place);
std::string read_text(const JsonPlace& place);

/// A text that is not empty and has no control characters, which would garble messages and paths.
std::string read_plain_text(const JsonPlace& place);

Vec3 read_vec3(const JsonPlace& place);

/// Three numbers that are not all zero.
Vec3 read_direction(const JsonPlace& place);

}  // namespace scb
