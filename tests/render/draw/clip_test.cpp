#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <tuple>

#include "core/volumes/shape.h"
#include "tests/render/draw/cpu_caster.h"
#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

constexpr int view_side = 200;
constexpr double view_height = 4;
constexpr Rgba8 body_color{60, 120, 200};

/// From +z, or from -y with z up: four units from top to bottom, the origin in the middle.
Camera camera_from(bool above, bool orthographic) {
    Camera camera = orbit_camera(0, above ? 90 : 0, Vec3::Zero(), 6, orthographic, 40);
    camera.view_height = view_height;
    camera.near_distance = 1;
    camera.far_distance = 12;
    return camera;
}

struct ClipTest : testing::Test {
    Drawing drawing;
    Picture picture;

    ClipTest() {
        picture.width = picture.height = view_side;
        picture.samples = 1;
        Pane& pane = picture.panes.emplace_back();
        pane.viewport = {0, 0, view_side, view_side};
    }
    Pane& pane() { return picture.panes[0]; }
    Camera& camera() { return pane().camera; }

    Rendering drawn() { return drawing.renderer.draw(picture, nullptr, true); }
    Rendering drawn(const AnyVolume& volume, std::uint8_t alpha = 255) {
        Rgba8 color = body_color;
        color.a = alpha;
        pane().volumes = {{volume, color, 1}};
        return drawn();
    }
};

int covered(const IdImage& ids) {
    return static_cast<int>(
        std::count_if(ids.ids.begin(), ids.ids.end(), [](std::uint32_t id) { return id != 0; }));
}

std::vector<std::pair<std::string, AnyVolume>> shapes() {
    const Mat3 axes = orbit_axes(25, 35);
    KDop14 dop;
    for (std::size_t i = 0; i < dop.which.size(); ++i) {
        dop.lower[i] = -1;
        dop.upper[i] = i < 3 ? 0.9 : 1.1;
    }
    return {{"ball", Ball{Vec3(0.1, 0, 0.1), 1.2}},
            {"scb", Scb{Vec3(0.1, 0, 0.1), 1.4, axes.col(2), 0.5, -0.6}},
            {"scb2", two_slabs(Vec3(0.1, 0, 0.1), 1.5, axes, 0.6, -0.5, 0.7, -0.9)},
            {"box", Obb{Vec3(0.1, 0, 0.1), axes, Vec3(1.1, 0.6, 0.9)}},
            {"polytope", placed(shape_of(dop), {axes, Vec3(0.1, 0, 0.1)})},
            {"rounded", placed(shape_of(Capsule{Vec3::Zero(), Vec3(0.6, 0.3, 0.9), 0.6}), {})}};
}

TEST_F(ClipTest, ABallThatIsCutIsASlabCutBall) {
    for (const bool orthographic : {true, false})
        for (const std::uint8_t alpha : {std::uint8_t{255}, std::uint8_t{120}}) {
            camera() = camera_from(true, orthographic);
            const Rendering expected = drawn(Scb{Vec3(0, 0, 0), 1, Vec3::UnitZ(), 0.3, -1}, alpha);
            camera().clip = FacePlane{Vec3::UnitZ(), 0.3};
            const Rendering cut = drawn(Ball{Vec3(0, 0, 0), 1}, alpha);
            EXPECT_EQ(*cut.ids, *expected.ids);
            EXPECT_GT(covered(*cut.ids), 1000);
            // The rim is as dark. The cross-section has one color, unlike the cap of a slab.
            double most = 0;
            for (std::size_t i = 0; i < cut.image.rgba.size(); ++i)
                most = std::max(most, std::abs(double(cut.image.rgba[i]) - expected.image.rgba[i]));
            EXPECT_LT(most, 70) << orthographic << int(alpha);
            const Rgba8 here = pixel(cut.image, view_side / 2, view_side / 2),
                        there = pixel(expected.image, view_side / 2, view_side / 2);
            EXPECT_LT(here.b, there.b - 4);
            EXPECT_GT(here.b, there.b - 40);
        }
}

// Seen from the side, with the plane edge on.
TEST_F(ClipTest, NothingIsLeftBeyondThePlaneAndAllOfItBefore) {
    for (const auto& [name, volume] : shapes())
        for (const bool orthographic : {true, false})
            for (const std::uint8_t alpha : {std::uint8_t{255}, std::uint8_t{120}}) {
                SCOPED_TRACE(name + (orthographic ? " orthographic " : " in perspective ") +
                             std::to_string(alpha));
                const double height = 0.4;
                camera() = camera_from(false, orthographic);
                if (!orthographic) camera().position[2] = height;
                const Rendering before = drawn(volume, alpha);
                camera().clip = FacePlane{Vec3::UnitZ(), height};
                const Rendering cut = drawn(volume, alpha);
                // It lies between two rows of pixels.
                const int edge = orthographic ? 80 : 100;
                ASSERT_GT(covered(*before.ids), 3000);
                int above = 0, lost = 0, colored = 0;
                for (int y = 0; y < view_side; ++y)
                    for (int x = 0; x < view_side; ++x) {
                        const std::uint32_t id = pixel(*cut.ids, x, y);
                        if (y < edge) {
                            above += id != 0;
                            colored += pixel(cut.image, x, y) != picture.background;
                        } else {
                            lost += id != pixel(*before.ids, x, y);
                        }
                    }
                EXPECT_EQ(above, 0);
                EXPECT_EQ(colored, 0);
                EXPECT_EQ(lost, 0);
                EXPECT_LT(covered(*cut.ids), covered(*before.ids) - 300);
                // Beyond it all.
                camera().clip = FacePlane{Vec3::UnitZ(), -3};
                EXPECT_EQ(covered(*drawn(volume, alpha).ids), 0);
                camera().clip = FacePlane{Vec3::UnitZ(), 3};
                EXPECT_EQ(*drawn(volume, alpha).ids, *before.ids);
            }
}

// One color within a rim, also where the volume's own surface would have lines.
TEST_F(ClipTest, ACrossSectionIsFlatWithinARim) {
    for (const auto& [name, volume] : shapes()) {
        if (name == "rounded") continue;  // which is open
        SCOPED_TRACE(name);
        camera() = camera_from(true, true);
        camera().clip = FacePlane{Vec3::UnitZ(), 0.15};
        const Rendering cut = drawn(volume);
        // A thin slice of the volume shows which pixels the cross-section has.
        camera().clip = FacePlane{-Vec3::UnitZ(), -0.15 + 1e-4};
        camera().position[2] = 0.1502;
        camera().near_distance = 1e-4;
        camera().far_distance = 4e-4;
        const IdImage slice = *drawn(volume).ids;
        std::set<std::tuple<int, int, int>> colors;
        int inner = 0, rim = 0, dark = 0;
        const Rgba8 middle = pixel(cut.image, view_side / 2 + 5, view_side / 2);
        for (int y = 3; y < view_side - 3; ++y)
            for (int x = 3; x < view_side - 3; ++x) {
                if (pixel(slice, x, y) == 0) continue;
                int around = 0;
                for (int dy = -3; dy <= 3; ++dy)
                    for (int dx = -3; dx <= 3; ++dx) around += pixel(slice, x + dx, y + dy) != 0;
                const Rgba8 c = pixel(cut.image, x, y);
                const bool at_rim = pixel(slice, x - 1, y) == 0 || pixel(slice, x + 1, y) == 0 ||
                                    pixel(slice, x, y - 1) == 0 || pixel(slice, x, y + 1) == 0;
                inner += around == 49;
                if (around == 49) colors.insert({c.r, c.g, c.b});
                rim += at_rim;
                dark += at_rim && c.b < 0.8 * middle.b;
            }
        EXPECT_GT(inner, 1000);
        EXPECT_EQ(colors.size(), 1u);
        EXPECT_GT(rim, 100);
        EXPECT_GT(dark, 0.95 * rim);
    }
}

TEST_F(ClipTest, WhatLiesInThePlaneIsDrawnWhole) {
    const Mesh mesh = quad();
    for (const bool orthographic : {true, false})
        for (const double tilt : {90.0, 50.0, 15.0}) {
            const Mat3 axes = orbit_axes(0, tilt);
            const Vec3 n = axes.col(2), at = 0.3 * n;
            camera() = camera_from(true, orthographic);
            MeshDraw draw;
            draw.mesh = drawing.renderer.upload(mesh);
            draw.first_id = 5;
            // Its normal is y.
            Mat3 turned;
            turned << axes.col(0), n, -axes.col(1);
            draw.pose = {turned, at};
            const Segment segment{at - axes.col(0), at + axes.col(0), {1, 2, 3}, 9};
            const std::vector<std::function<void()>> things = {
                [&] {
                    pane().volumes = {{Scb{at, 1, n, 0, 0}, body_color, 1}};
                },
                [&] {
                    pane().volumes = {{Obb{at, axes, Vec3(1, 0.7, 0)}, body_color, 1}};
                },
                [&] { pane().meshes = {draw}; }, [&] { pane().segments = {segment}; }};
            for (std::size_t i = 0; i < things.size(); ++i) {
                SCOPED_TRACE(testing::Message() << i << ' ' << orthographic << ' ' << tilt);
                pane().volumes.clear();
                pane().meshes.clear();
                pane().segments.clear();
                things[i]();
                camera().clip.reset();
                const IdImage whole = *drawn().ids;
                EXPECT_GT(covered(whole), 100);
                for (const double sign : {1.0, -1.0}) {
                    camera().clip = FacePlane{sign * n, sign * 0.3};
                    EXPECT_EQ(*drawn().ids, whole);
                    camera().clip->offset -= 1e-3;
                    EXPECT_EQ(covered(*drawn().ids), 0);
                }
            }
        }
}

TEST_F(ClipTest, MeshesAndLinesEndAtThePlane) {
    const Mesh mesh = quad();
    MeshDraw draw;
    draw.mesh = drawing.renderer.upload(mesh);
    draw.first_id = 5;
    for (const bool orthographic : {true, false}) {
        camera() = camera_from(false, orthographic);
        pane().meshes = {draw};
        // Upright lines: among opaque things, on top, and one in which surfaces meet.
        pane().segments = {
            {Vec3(-0.5, -0.1, -0.9), Vec3(-0.5, -0.1, 0.9), {1, 2, 3}, 9},
            {Vec3(0, 0.5, -0.9), Vec3(0, 0.5, 0.9), {1, 2, 3}, 10, 3, true},
            {Vec3(0.5, 0, -0.9), Vec3(0.5, 0, 0.9), {1, 2, 3}, 11, 3, false, Rgba8{90, 90, 90}}};
        const IdImage whole = *drawn().ids;
        camera().clip = FacePlane{Vec3::UnitZ(), 0.2};
        const IdImage cut = *drawn().ids;
        std::set<std::uint32_t> below;
        int above = 0, lost = 0;
        const double limit = project(camera(), Vec3(0, 0, 0.2), view_side, view_side)[1];
        for (int y = 0; y < view_side; ++y)
            for (int x = 0; x < view_side; ++x) {
                const std::uint32_t id = pixel(cut, x, y), was = pixel(whole, x, y);
                below.insert(id);
                // The lines are beside the plane of the mesh, and so seen at other heights.
                const int leave = was == 5 || was == 6 || orthographic ? 0 : 2;
                above += y + 0.5 < limit - leave && id != 0;
                lost += y + 0.5 > limit + leave && id != was;
            }
        EXPECT_EQ(above, 0) << orthographic;
        EXPECT_EQ(lost, 0) << orthographic;
        EXPECT_EQ(below, (std::set<std::uint32_t>{0, 5, 6, 9, 10, 11}));
    }
}

// The cuts of all volumes lie in one plane, so ids decide, for all of a cut.
TEST_F(ClipTest, OfCutsThatOverlapTheHigherIdIsDrawnWhole) {
    const Ball a{Vec3(0, 0, 0), 1}, b{Vec3(0.3, 0.2, -0.1), 1};
    const Obb c{Vec3(-0.2, 0, 0), orbit_axes(20, 70), Vec3(0.6, 0.8, 0.7)};
    const Scb d{Vec3(0, 0.4, 0.1), 0.9, orbit_axes(80, 10).col(2), 0.3, -0.5};
    for (const bool orthographic : {true, false})
        for (const double tilt : {90.0, 30.0, 12.0}) {
            camera() = camera_from(true, orthographic);
            const Vec3 n = orbit_axes(10, tilt).col(2);
            camera().clip = FacePlane{n, 0.05};
            pane().volumes = {
                {a, body_color, 1}, {b, body_color, 2}, {c, body_color, 3}, {d, body_color, 4}};
            const IdImage ids = *drawn().ids;
            int seen = 0, wrong = 0;
            for (int y = 0; y < view_side; ++y)
                for (int x = 0; x < view_side; ++x) {
                    const Ray ray = ray_through(pane(), x + 0.5, y + 0.5);
                    const double at = (0.05 - dot(n, ray.origin)) / dot(n, ray.direction);
                    const Span spans[] = {intersect(ray, a), intersect(ray, b), intersect(ray, c),
                                          intersect(ray, d)};
                    std::uint32_t highest = 0;
                    bool certain = true;
                    for (std::uint32_t i = 0; i < 4; ++i) {
                        const auto& [entry, exit] = spans[i];
                        if (entry < at && at < exit) highest = i + 1;
                        certain = certain && (entry > exit || (std::abs(at - entry) > 1e-3 &&
                                                               std::abs(at - exit) > 1e-3));
                    }
                    if (highest == 0 || !certain) continue;
                    ++seen;
                    wrong += pixel(ids, x, y) != highest;
                }
            EXPECT_GT(seen, 500) << tilt;
            // Rounding lets a face be a little in front of the plane; it is not drawn in front of
            // it.
            const double slack = orthographic ? 3e-6 * camera().far_distance : 3e-6 * 6;
            const Mat3 axes = orbit_axes(10, tilt);
            const Obb face{(0.05 + slack) * n - 0.2 * n, axes, Vec3(0.5, 0.5, 0.2)};
            pane().volumes = {{face, body_color, 1}, {a, body_color, 2}};
            EXPECT_EQ(pixel(*drawn().ids, view_side / 2, view_side / 2), 2u) << tilt;
            EXPECT_EQ(wrong, 0) << "of " << seen << ", tilt " << tilt << ", orthographic "
                                << orthographic;
        }
}

}  // namespace
}  // namespace scb::render
