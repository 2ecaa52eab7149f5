#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "golden/compare/pixel_box.h"
#include "render/files/image.h"

namespace scb::golden {

/// The numbers of pixels of one id in an id picture, before and after.
struct IdChange {
    std::uint32_t id = 0;
    std::size_t before = 0, after = 0;  ///< 0: the id is not there
    std::size_t moved = 0;              ///< pixels with this id on one side only
    PixelBox box;                       ///< about these

    friend bool operator==(const IdChange&, const IdChange&) = default;
};

struct IdDifference {
    std::size_t pixels = 0;         ///< pixels whose owner differs
    PixelBox box;                   ///< about all of these
    std::vector<IdChange> changes;  ///< things that appeared or vanished first, then by `moved`,
                                    ///< most first; ties by id. Without the background (0).

    friend bool operator==(const IdDifference&, const IdDifference&) = default;
};

/// Compares two id pictures. The sizes must be equal.
IdDifference id_difference(const render::IdImage& before, const render::IdImage& after);

/// A visible form of an id picture: every id has a color of its own, and consecutive ids are far
/// apart in hue. (In an id picture, alpha is a byte of the id, mostly 0.)
render::Image shown_ids(const render::IdImage& ids);

/// The pixels whose owner differs, on a pale picture of the new owners. Both must have one size.
render::Image shown_id_difference(const render::IdImage& before, const render::IdImage& after);

}  // namespace scb::golden
