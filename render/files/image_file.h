#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/files/image.h"

namespace scb::render {

/// The PNG file of a picture: 8 bits a channel, without alpha where every pixel is opaque. The same
/// picture always gives the same bytes (with the same zlib).
std::vector<std::uint8_t> encode_png(const Image& image);

/// The PNG file of an id image, losslessly: red, green, blue, alpha are the bytes of the id, the
/// lowest first.
std::vector<std::uint8_t> encode_png(const IdImage& image);

/// Reads a picture from a PNG file. Throws InputError where there is no such file, it is not a PNG
/// of 8 bits a channel, or none at all but a pipe or a device, which need not end.
Image read_png(const std::filesystem::path& path);

/// The ids of a picture as encode_png(IdImage) packs them.
IdImage unpack_ids(const Image& image);

}  // namespace scb::render
