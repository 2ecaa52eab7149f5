#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "render/files/image.h"

namespace scb::render {

/// A file of several pictures of one size, written whole or not at all. All functions throw
/// OutputError if that fails.
class Animation {
  public:
    virtual ~Animation() = default;

    /// Takes over the next frame, which must have the animation's size. Blocks while the encoder is
    /// behind, so that memory stays bounded.
    virtual void push(Image image) = 0;
    virtual std::size_t frames() const = 0;
    /// Writes the file, of one frame or more. Without finish() nothing is written.
    virtual void finish() = 0;
};

/// By the name's extension: a WebpFile for .webp, else a VideoFile. `background`: see VideoFile.
std::unique_ptr<Animation> animation_file(const std::filesystem::path& path, int width, int height,
                                          int frames_per_second, Rgba8 background);

/// Whether it is the name of a WebpFile, which needs no other program.
bool is_webp_name(const std::filesystem::path& path);

}  // namespace scb::render
