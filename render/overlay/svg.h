#pragma once

#include <string>

#include "render/overlay/overlay_shape.h"

namespace scb::render {

/// The picture as SVG 1.1: the shapes that an overlay has noted, in its order, over `views`, which
/// is an image of the scene without them; nullptr: over the background alone. Letters are text in
/// Roboto, or in another face without serifs, as wide as the overlay has measured them. The same
/// picture always gives the same bytes.
std::string svg_text(const OverlayShapes& shapes, const Picture& picture, const Image* views);

}  // namespace scb::render
