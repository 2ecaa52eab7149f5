#include "render/figures/seeing_direction.h"

#include <algorithm>

#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

/// A ball behind or before a wall in the plane y = 0; its score is the number of its pixels.
Subject wall_and_ball(Renderer& renderer, double y) {
    Subject subject;
    Pane& pane = subject.pane;
    MeshDraw wall;
    wall.mesh = renderer.upload(quad());
    pane.meshes.push_back(wall);
    pane.volumes.push_back({Ball{Vec3(0, y, 0), 0.3}, {255, 0, 0}, 1});
    subject.score = [](const IdImage& ids) {
        return static_cast<std::uint64_t>(std::count(ids.ids.begin(), ids.ids.end(), 1u));
    };
    return subject;
}

SeeingDirection found(Renderer& renderer, const Subject& subject, const SeeingDirection& usual) {
    const std::vector<AnyVolume> shown = {Ball{Vec3(0, 0, 0), 2}};
    const Support whole = support_of(shown);
    return seeing_direction(renderer, subject, 1, usual, [&](double azimuth, double elevation) {
        return fit_camera(orbit_axes(azimuth, elevation), whole, {1, 0.04, true, 30});
    });
}

TEST(SeeingDirection, IsTheUsualOneIfNoneSeesMore) {
    Drawing drawing;
    const Subject subject = wall_and_ball(drawing.renderer, -1);
    const SeeingDirection direction = found(drawing.renderer, subject, {0, 0});
    EXPECT_EQ(direction.azimuth, 0);
    EXPECT_EQ(direction.elevation, 0);
    EXPECT_GT(direction.score, 200u);
}

TEST(SeeingDirection, IsOneFromTheSideOnWhichTheSubjectIs) {
    Drawing drawing;
    const Subject subject = wall_and_ball(drawing.renderer, 1);
    const SeeingDirection direction = found(drawing.renderer, subject, {0, 0});
    const SeeingDirection in_front =
        found(drawing.renderer, wall_and_ball(drawing.renderer, -1), {0, 0});
    EXPECT_NE(direction.azimuth, 0);
    EXPECT_GE(direction.score, in_front.score * 8 / 10);
    const SeeingDirection again = found(drawing.renderer, subject, {0, 0});
    EXPECT_EQ(again.azimuth, direction.azimuth);
    EXPECT_EQ(again.elevation, direction.elevation);
}

}  // namespace
}  // namespace scb::render
