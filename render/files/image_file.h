#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/files/image.h"

namespace scb::render {

/// What a PNG file says beside its pixels, such as which program drew it. `keyword`: 1 to 79 plain
/// characters, as the PNG specification wants it; `text`: UTF-8.
struct PngText {
    std::string keyword, text;
};

/// The PNG file of a picture: 8 bits a channel, without alpha where every pixel is opaque. The same
/// picture with the same texts always gives the same bytes (with the same zlib).
std::vector<std::uint8_t> encode_png(const Image& image, const std::vector<PngText>& texts = {});

/// The PNG file of an id image, losslessly: red, green, blue, alpha are the bytes of the id, the
/// lowest first.
std::vector<std::uint8_t> encode_png(const IdImage& image, const std::vector<PngText>& texts = {});

/// Reads a picture from a PNG file. Throws InputError where there is no such file, it is not a PNG
/// of 8 bits a channel, or none at all but a pipe or a device, which need not end.
Image read_png(const std::filesystem::path& path);

/// The ids of a picture as encode_png(IdImage) packs them.
IdImage unpack_ids(const Image& image);

}  // namespace scb::render
