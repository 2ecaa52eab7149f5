#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "render/draw/eye_view.h"
#include "render/view/picture.h"

namespace scb::render {

/// A volume as shaders/volume.vert reads it: five texels of four words. 0: its rectangle on the
/// screen (left, bottom, right, top in normalised device coordinates); 1 to 3: its shape in eye
/// space; 4: color, id (its highest bit: hatched), and further numbers of the shape. For rounded
/// volumes, 1 to 3 are the axes of the frame; for polytopes, 1 is the center; see ConvexPoints.
struct PackedVolume {
    enum class Shape { scb, scb2, obb, polytope, convex } shape;
    std::array<std::uint32_t, 20> words;
};

/// Nothing if the volume is outside the view, or has no size.
std::optional<PackedVolume> pack(const VolumeInstance& instance, const EyeView& view);

}  // namespace scb::render
