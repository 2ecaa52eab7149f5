#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "render/files/image.h"

namespace scb::render {

/// Pictures of one size that become one file, which is written whole or not at all. All functions
/// throw OutputError where that fails.
class Animation {
  public:
    virtual ~Animation() = default;

    /// Takes over the next frame, which has the animation's size. Memory stays flat: blocks while
    /// the encoder is behind.
    virtual void push(Image image) = 0;
    virtual std::size_t frames() const = 0;
    /// Writes the file, of one frame or more. Without it nothing is written.
    virtual void finish() = 0;
};

/// By the ending of the name: a VideoFile, or of .webp a WebpFile. `background`: see VideoFile.
std::unique_ptr<Animation> animation_file(const std::filesystem::path& path, int width, int height,
                                          int frames_per_second, Rgba8 background);

/// Whether that name is one of a WebpFile, which needs no other program.
bool is_webp_name(const std::filesystem::path& path);

}  // namespace scb::render
