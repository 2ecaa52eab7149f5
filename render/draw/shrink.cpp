#include "render/draw/shrink.h"

#include <new>

#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <stb_image_resize.h>
#pragma GCC diagnostic pop

namespace scb::render {

Image shrunk(const Image& picture, const PixelRect& part, int width, int height) {
    Image image{width, height, {}};
    image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const std::size_t first =
        4 * (static_cast<std::size_t>(part.y) * static_cast<std::size_t>(picture.width) +
             static_cast<std::size_t>(part.x));
    if (!stbir_resize_uint8_generic(picture.rgba.data() + first, part.width, part.height,
                                    4 * picture.width, image.rgba.data(), width, height, 0, 4,
                                    STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP, STBIR_FILTER_BOX,
                                    STBIR_COLORSPACE_LINEAR, nullptr))
        throw std::bad_alloc();
    return image;
}

}  // namespace scb::render
