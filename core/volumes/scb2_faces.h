#pragma once

#include <array>

#include "scb/scb2.h"

namespace scb {

/// Areas of what the surface of an Scb2 is made of.
struct Scb2Faces {
    double sphere = 0;  ///< of what the slabs leave of the sphere
    /// Of what the ball and the other slab leave of the planes: per slab, upper and lower.
    std::array<std::array<double, 2>, 2> planes{};
};

/// In closed form: the sphere's part is an integral of arcs over their height (Archimedes).
Scb2Faces faces(const Scb2& scb);

}  // namespace scb
