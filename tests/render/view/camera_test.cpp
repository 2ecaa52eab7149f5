#include "scb/error.h"
#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

TEST(Camera, AzimuthZeroLooksAlongYWithXToTheRight) {
    const Camera camera = orbit_camera(0, 0, Vec3(1, 2, 3), 5);
    EXPECT_EQ(camera.position, Vec3(1, -3, 3));
    const Vec3 right = project(camera, Vec3(2, 2, 3), 200, 100);
    EXPECT_GT(right[0], 100);
    EXPECT_DOUBLE_EQ(right[1], 50);
    EXPECT_DOUBLE_EQ(right[2], 5);
    EXPECT_LT(project(camera, Vec3(1, 2, 4), 200, 100)[1], 50);
}

TEST(Camera, AxesAreRotationsAtAnyAngle) {
    for (int azimuth = -180; azimuth <= 360; azimuth += 45)
        for (int elevation = -90; elevation <= 90; elevation += 30) {
            const Mat3 axes = orbit_axes(azimuth, elevation);
            EXPECT_LT(rigidity_defect({axes, Vec3::Zero()}), 1e-15);
        }
}

TEST(Camera, ABallSpansItsPixels) {
    const Camera camera = orbit_camera(30, 20, Vec3(1, 1, 1), 10, true);
    EXPECT_NEAR(pixels_per_unit(camera, Vec3(1, 1, 1), 500) * camera.view_height, 500, 1e-9);
    const Camera perspective = orbit_camera(30, 20, Vec3(1, 1, 1), 10);
    EXPECT_NEAR(pixels_per_unit(perspective, Vec3(1, 1, 1), 500) * perspective.view_height, 500,
                1e-9);
}

struct Bounds {
    int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
};

Bounds drawn_bounds(const IdImage& ids) {
    Bounds bounds;
    for (int y = 0; y < ids.height; ++y)
        for (int x = 0; x < ids.width; ++x)
            if (pixel(ids, x, y) != 0)
                bounds = {std::min(bounds.left, x), std::min(bounds.top, y),
                          std::max(bounds.right, x), std::max(bounds.bottom, y)};
    return bounds;
}

TEST(FitCamera, EverythingIsInsideAndTouchesTheMargins) {
    Drawing drawing;
    const std::vector<AnyVolume> volumes = assorted_volumes();
    for (const bool orthographic : {false, true})
        for (const double elevation : {-70.0, 0.0, 25.0, 90.0}) {
            const int width = 400, height = 300;
            Picture picture = picture_of(volumes, width, height, 1);
            const double margin = 0.05;
            picture.panes[0].camera = fit_camera(orbit_axes(15, elevation), support_of(volumes),
                                                 {4.0 / 3, margin, orthographic, 40});
            const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
            const Bounds b = drawn_bounds(*rendering.ids);
            const int x = static_cast<int>(margin * width), y = static_cast<int>(margin * height);
            EXPECT_GE(b.left, x - 1);
            EXPECT_GE(b.top, y - 1);
            EXPECT_LE(b.right, width - x);
            EXPECT_LE(b.bottom, height - y);
            const int sharp = 3;  // pixels in which the corner of a box covers no pixel's center
            const bool touches_sides = b.left <= x + sharp && b.right >= width - x - 1 - sharp;
            const bool touches_ends = b.top <= y + sharp && b.bottom >= height - y - 1 - sharp;
            EXPECT_TRUE(touches_sides || touches_ends)
                << b.left << ' ' << b.right << ' ' << b.top << ' ' << b.bottom;
        }
}

TEST(FitCamera, CentersSpreadAsTheCameraSeesThem) {
    // From along y, 10 away: x is to the side, z is up, and what is nearer spreads more.
    const std::vector<AnyVolume> balls = {Ball{{-1, 0, 0}, 5}, Ball{{3, 0, 0.5}, 7}};
    const Camera camera = orbit_camera(0, 0, {0, 0, 0}, 10, true);
    EXPECT_NEAR(extent_in_view(camera, balls), 4 / camera.view_height, 1e-12);
    const Camera from_the_side = orbit_camera(90, 0, {0, 0, 0}, 10, true);
    EXPECT_NEAR(extent_in_view(from_the_side, balls), 0.5 / camera.view_height, 1e-12);
    EXPECT_EQ(extent_in_view(camera, {}), 0);

    const Ball held = ball_about_centers(balls);
    for (const AnyVolume& ball : balls)
        EXPECT_LE(std::sqrt(squared_norm(center(ball) - held.center)), held.radius);
    EXPECT_LT(held.radius, 5);
    EXPECT_EQ(ball_about_centers(std::vector<AnyVolume>{Ball{{1, 2, 3}, 4}}).radius, 0);
}

TEST(FitCamera, NothingIsCutOffByTheDepthRange) {
    const std::vector<AnyVolume> volumes = {Ball{Vec3(0, 0, 0), 1}};
    const Camera camera = fit_camera(orbit_axes(0, 0), support_of(volumes));
    const double distance = -to_eye(camera, Vec3(0, 0, 0))[2];
    EXPECT_LT(camera.near_distance, distance - 1);
    EXPECT_GT(camera.far_distance, distance + 1);
}

TEST(FitCamera, FitsTheUsedVerticesOfAMeshInItsPose) {
    Mesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(1000, 1000, 1000)};
    mesh.triangles = {{0, 1, 2}};
    const Pose pose{orbit_axes(90, 0), Vec3(5, 6, 7)};
    const Support support = support_of_all({support_of(mesh, pose)});
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1)}) {
        double expected = -1e300;
        for (std::size_t i = 0; i < 3; ++i)
            expected = std::max(expected, dot(transform_point(pose, mesh.vertices[i]), direction));
        EXPECT_NEAR(support(direction), expected, 1e-12);
    }
}

TEST(FitCamera, ASinglePointIsLookedAt) {
    const std::vector<AnyVolume> volumes = {Ball{Vec3(3, 4, 5), 0}};
    for (const bool orthographic : {false, true}) {
        const Camera camera =
            fit_camera(orbit_axes(30, 20), support_of(volumes), {1.5, 0.04, orthographic, 30});
        const Vec3 at = project(camera, Vec3(3, 4, 5), 300, 200);
        EXPECT_NEAR(at[0], 150, 1e-6);
        EXPECT_NEAR(at[1], 100, 1e-6);
        EXPECT_GT(at[2], camera.near_distance);
        EXPECT_LT(at[2], camera.far_distance);
    }
}

TEST(FitCamera, RefusesAnEmptySet) {
    EXPECT_THROW(fit_camera(orbit_axes(0, 0), support_of(std::vector<AnyVolume>{})), InputError);
}

}  // namespace
}  // namespace scb::render
