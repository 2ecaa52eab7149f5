#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "golden/compare/pixel_box.h"
#include "render/files/image.h"

namespace scb::golden {

/// How many pixels a thing of an id picture has, before and after.
struct IdChange {
    std::uint32_t id = 0;
    std::size_t before = 0, after = 0;  ///< 0: it is not there
    std::size_t moved = 0;              ///< pixels that it has on one side only
    PixelBox box;                       ///< about these

    friend bool operator==(const IdChange&, const IdChange&) = default;
};

struct IdDifference {
    std::size_t pixels = 0;         ///< whose owner differs
    PixelBox box;                   ///< about all of these
    std::vector<IdChange> changes;  ///< things that appeared or vanished first, then by `moved`,
                                    ///< most first; ties by id. Without the background (0).

    friend bool operator==(const IdDifference&, const IdDifference&) = default;
};

/// Compares two id pictures. The sizes must be equal.
IdDifference id_difference(const render::IdImage& before, const render::IdImage& after);

}  // namespace scb::golden
