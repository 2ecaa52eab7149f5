#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <vector>

#include "render/image.h"

namespace scb {

/// A file could not be written: the disk is full, the folder is missing or may not be written.
/// `what()` is one sentence that names the file, the system's reason and what to do. A program that
/// meets it exits with status 3.
struct OutputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The PNG file of a picture: 8 bits a channel, without alpha where every pixel is opaque. The same
/// picture always gives the same bytes (with the same zlib).
std::vector<std::uint8_t> encode_png(const Image& image);

/// The PNG file of an id image, losslessly: red, green, blue, alpha are the bytes of the id, the
/// lowest first.
std::vector<std::uint8_t> encode_png(const IdImage& image);

/// Reads a picture from a PNG file. Throws InputError where there is no such file or it is no PNG.
Image read_png(const std::filesystem::path& path);

/// The ids of a picture as encode_png(IdImage) packs them.
IdImage unpack_ids(const Image& image);

/// Writes the file whole or not at all: to a new file in the same folder, whose name starts with
/// that of `path` and is its own, then renamed over `path`; several threads and programs may write
/// the same path, and one of them is the last. The file has the permissions that any new file gets.
/// Throws OutputError, and leaves neither a temporary file nor a changed `path` behind.
void write_file_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace scb
