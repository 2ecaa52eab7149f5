#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/text_format.h"
#include "scb/error.h"
#include "scb/mesh.h"
#include "scenes/shapes/procedural.h"

namespace scb::scenes {

/// Checks of the parameters of procedural meshes; each throws InputError with a sentence that
/// starts with the parameter's name, so that a caller can put the place in front of it.

inline void require_between(const char* name, std::int64_t value, std::int64_t low,
                            std::int64_t high) {
    if (value >= low && value <= high) return;
    throw InputError(std::string(name) + " is " + std::to_string(value) + "; give " +
                     std::to_string(low) + " to " + std::to_string(high) + ".");
}

/// A length that is positive and small enough that squares of distances stay finite.
inline void require_length(const char* name, double value) {
    if (value > 0 && value <= max_coordinate) return;
    throw InputError(std::string(name) + " is " + exact_number(value) +
                     "; give a length above 0 and at most " + exact_number(max_coordinate) + ".");
}

inline void require_triangles(std::int64_t count) {
    if (count <= max_procedural_triangles) return;
    throw InputError("this makes " + std::to_string(count) + " triangles; at most " +
                     std::to_string(max_procedural_triangles) +
                     " are allowed, so make it coarser.");
}

}  // namespace scb::scenes
