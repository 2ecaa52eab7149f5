#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/platform/file_window.h"

namespace scb::scenes {

enum class PlyEncoding { text, little_endian, big_endian };

/// A type of numbers: char, ushort, float64 and so on.
struct PlyType {
    std::size_t size = 0;  ///< bytes, if the encoding is binary
    bool is_float = false, is_signed = false;
};

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> list_length;  ///< set if the property is a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::text;
    std::vector<PlyElement> elements;
};

/// Reads the header of a PLY file, up to the first byte of its first element (Greg Turk, The PLY
/// Polygon File Format, 1994). Header lines with unknown words count as remarks, since some writers
/// omit the word comment, unless they look like a misspelled element or property. Lines end like
/// the first one: with a line feed, with or without a carriage return, or with a carriage return
/// alone.
///
/// Throws InputError that names the file and the line.
PlyHeader read_ply_header(FileWindow& file);

}  // namespace scb::scenes
