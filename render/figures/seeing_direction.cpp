#include "render/figures/seeing_direction.h"

#include <algorithm>
#include <vector>

namespace scb::render {
namespace {

/// Small, so that the many pictures take no longer than the one that is shown.
constexpr int tried_height = 120, least_tried_width = 40, most_tried_width = 480;

std::vector<SeeingDirection> directions(const SeeingDirection& usual) {
    std::vector<SeeingDirection> all = {usual};
    for (const double elevation : {20, 50, -30})
        for (int i = 0; i < 8; ++i) all.push_back({45.0 * i - 15, elevation});
    all.push_back({0, 90});
    all.push_back({0, -90});
    return all;
}

}  // namespace

SeeingDirection seeing_direction(
    Renderer& renderer, Subject subject, double aspect, const SeeingDirection& usual,
    const std::function<Camera(double azimuth, double elevation)>& camera_of) {
    Picture picture;
    picture.height = tried_height;
    picture.width =
        std::clamp(static_cast<int>(aspect * tried_height), least_tried_width, most_tried_width);
    picture.samples = 1;
    subject.pane.viewport = {0, 0, picture.width, picture.height};
    picture.panes.push_back(std::move(subject.pane));
    // Parts seen from below are hard to recognize, so another direction need show half as much.
    const auto value = [](const SeeingDirection& direction) {
        return direction.elevation < 0 ? direction.score / 2 : direction.score;
    };
    std::vector<SeeingDirection> tried = directions(usual);
    std::uint64_t most = 0;
    for (SeeingDirection& direction : tried) {
        picture.panes[0].camera = camera_of(direction.azimuth, direction.elevation);
        direction.score = subject.score(*renderer.draw(picture, nullptr, true).ids);
        most = std::max(most, value(direction));
    }
    // The grid of pixels makes some percent of difference.
    return *std::find_if(tried.begin(), tried.end(), [&](const SeeingDirection& direction) {
        return value(direction) >= most - most / 10;
    });
}

}  // namespace scb::render
