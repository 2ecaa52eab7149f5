#pragma once

#include <array>

#include "scb/scb2.h"

namespace scb {

/// The areas of the faces of an Scb2.
struct Scb2Faces {
    double sphere = 0;  ///< the part of the sphere inside the slabs
    /// The parts of the planes inside the ball and the other slab: per slab, upper and lower.
    std::array<std::array<double, 2>, 2> planes{};
};

/// In closed form: the sphere's part is an integral of arcs over their height (Archimedes).
Scb2Faces faces(const Scb2& scb);

}  // namespace scb
