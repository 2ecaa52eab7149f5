#pragma once

#include "render/files/image.h"
#include "render/view/picture.h"

namespace scb::render {

/// A part of a picture, shrunk to the given size: each pixel is the mean of the pixels that it
/// covers. The part must be inside the picture and not be smaller than the result.
Image shrunk(const Image& picture, const PixelRect& part, int width, int height);

}  // namespace scb::render
