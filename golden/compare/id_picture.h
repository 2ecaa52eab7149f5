#pragma once

#include "render/files/image.h"

namespace scb::golden {

/// A visible form of an id picture: every id has a color of its own, and consecutive ids are far
/// apart in hue. (In an id picture, alpha is a byte of the id, mostly 0.)
render::Image shown_ids(const render::IdImage& ids);

/// The pixels whose owner differs, on a pale picture of the new owners. Both must have one size.
render::Image shown_id_difference(const render::IdImage& before, const render::IdImage& after);

}  // namespace scb::golden
