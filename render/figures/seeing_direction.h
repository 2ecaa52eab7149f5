#pragma once

#include <cstdint>
#include <functional>

#include "render/draw/renderer.h"
#include "render/view/camera.h"

namespace scb::render {

/// Things to be seen, and how well a small picture of them shows them: 0 if not at all.
struct Subject {
    Pane pane;
    std::function<std::uint64_t(const IdImage&)> score;
};

/// A direction of view in degrees, see orbit_axes, and the score of the subject from there.
struct SeeingDirection {
    double azimuth = 0;
    double elevation = 0;
    std::uint64_t score = 0;
};

/// How many directions seeing_direction tries.
inline constexpr int tried_directions = 27;

/// The direction of view from which the subject has the highest score: `usual`, or one of 26 around
/// the scene. From below, a score counts half. Of those with nearly the highest score the first:
/// `usual`, then from slightly above, from above and from below, each by azimuth. `camera_of`
/// places a camera that looks in a direction; `aspect` is width / height of its view.
SeeingDirection seeing_direction(
    Renderer& renderer, Subject subject, double aspect, const SeeingDirection& usual,
    const std::function<Camera(double azimuth, double elevation)>& camera_of);

}  // namespace scb::render
