#include "render/files/animation.h"

#include "render/files/video_file.h"
#include "render/files/webp_file.h"

namespace scb::render {

std::unique_ptr<Animation> animation_file(const std::filesystem::path& path, int width, int height,
                                          int frames_per_second, Rgba8 background) {
    if (is_webp_name(path))
        return std::make_unique<WebpFile>(path, width, height, frames_per_second);
    return std::make_unique<VideoFile>(path, width, height, frames_per_second, background);
}

bool is_webp_name(const std::filesystem::path& path) { return path.extension() == ".webp"; }

}  // namespace scb::render
