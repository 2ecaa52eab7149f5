#pragma once

#include "render/files/image.h"
#include "render/view/picture.h"

namespace scb::render {

/// A part of a picture, smaller: as many pixels as given, each the mean of those that it covers.
/// The part must be inside the picture and not be smaller than the result.
Image shrunk(const Image& picture, const PixelRect& part, int width, int height);

}  // namespace scb::render
