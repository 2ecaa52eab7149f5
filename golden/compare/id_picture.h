#pragma once

#include "render/files/image.h"

namespace scb::golden {

/// An id picture as people can see it, in which every thing has a color of its own, and neighbors
/// in number are far apart in hue. The ids' own alpha is a byte of the id, mostly 0.
render::Image shown_ids(const render::IdImage& ids);

/// The pixels whose owner differs, on a pale picture of the new owners. Both of one size.
render::Image shown_id_difference(const render::IdImage& before, const render::IdImage& after);

}  // namespace scb::golden
