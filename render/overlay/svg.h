#pragma once

#include <string>

#include "render/overlay/overlay_shape.h"

namespace scb::render {

/// The picture as SVG 1.1: the shapes that an overlay has recorded, in its order, over `views`, an
/// image of the scene without them; nullptr: over the background alone. Letters are text in Roboto,
/// or in another sans-serif face, as wide as the overlay has measured them. The same picture always
/// gives the same bytes.
std::string svg_text(const OverlayShapes& shapes, const Picture& picture, const Image* views);

}  // namespace scb::render
