#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/files/image.h"

namespace scb::render {

/// A text in a PNG file, such as the name of the program. `keyword`: 1 to 79 plain characters, as
/// the PNG specification requires; `text`: UTF-8.
struct PngText {
    std::string keyword, text;
};

/// The PNG file of a picture: 8 bits a channel, without alpha if every pixel is opaque. The same
/// picture with the same texts always gives the same bytes (with the same zlib).
std::vector<std::uint8_t> encode_png(const Image& image, const std::vector<PngText>& texts = {});

/// The PNG file of an id image, losslessly: red, green, blue, alpha are the bytes of the id, the
/// lowest first.
std::vector<std::uint8_t> encode_png(const IdImage& image, const std::vector<PngText>& texts = {});

/// Reads a picture from a PNG file. Throws InputError if there is no such file, if it is not a PNG
/// of 8 bits a channel, or if it is a pipe or a device, which may be endless.
Image read_png(const std::filesystem::path& path);

/// The ids of a picture as encode_png(IdImage) packs them.
IdImage unpack_ids(const Image& image);

}  // namespace scb::render
