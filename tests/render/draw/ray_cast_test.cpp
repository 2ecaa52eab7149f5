#include <string>

#include "core/volumes/shape.h"

#include "tests/render/draw/cpu_caster.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/unless_sanitized.h"

namespace scb::render {
namespace {

/// Every pixel that the caster is certain of has its id, and it is certain of nearly all.
void expect_same_ids(const Picture& picture, const IdImage& ids) {
    const Pane& pane = picture.panes.front();
    const double offset = picture.samples == 4 ? 0.25 : 0.5;  // the sample that gives the id
    int wrong = 0, uncertain = 0, covered = 0;
    std::string first;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::optional<std::uint32_t> expected = certain_id(pane, x + offset, y + offset);
            const std::uint32_t drawn = pixel(ids, x, y);
            covered += drawn != 0;
            if (!expected) {
                ++uncertain;
            } else if (*expected != drawn && ++wrong == 1) {
                first = "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " +
                        std::to_string(drawn) + ", not " + std::to_string(*expected);
            }
        }
    EXPECT_EQ(wrong, 0) << first;
    EXPECT_LT(uncertain, 0.005 * picture.width * picture.height);
    EXPECT_GT(covered, 0);
}

class RayCast : public testing::TestWithParam<int> {
  protected:
    void draw_and_compare(const Picture& picture) {
        const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
        expect_same_ids(picture, *rendering.ids);
    }
    Drawing drawing;
};

TEST_P(RayCast, AgreesInPerspective) {
    draw_and_compare(picture_of(assorted_volumes(), 240, 180, GetParam()));
}

TEST_P(RayCast, AgreesInOrthographicView) {
    const std::vector<AnyVolume> volumes = assorted_volumes();
    Picture picture = picture_of(volumes, 240, 180, GetParam());
    picture.panes[0].camera =
        fit_camera(orbit_axes(-20, 50), support_of(volumes), {4.0 / 3, 0.04, true, 30});
    draw_and_compare(picture);
}

TEST_P(RayCast, AgreesFromTheAxesOfTheSlabs) {
    // Planes seen exactly edge on and face on.
    const std::vector<AnyVolume> volumes = {
        Scb{Vec3(0, 0, 0), 1, Vec3::UnitZ(), 0.3, -0.2},
        Scb{Vec3(2.5, 0, 0), 1, Vec3::UnitY(), 0.3, -0.2},
        Scb{Vec3(0, 0, 2.5), 1, Vec3::UnitX(), 0.3, -0.2},
        two_slabs(Vec3(0, 2.5, 2.5), 1, Mat3::Identity(), 0.3, -0.2, 0.4, -0.7),
        Obb{Vec3(2.5, 0, 2.5), Mat3::Identity(), Vec3(1, 0.5, 0.7)}};
    for (const bool orthographic : {false, true}) {
        Picture picture = picture_of(volumes, 150, 150, GetParam());
        picture.panes[0].camera =
            fit_camera(orbit_axes(0, 0), support_of(volumes), {1, 0.04, orthographic, 30});
        draw_and_compare(picture);
    }
}

TEST_P(RayCast, ShowsTheInnerSideToAnEyeInside) {
    const std::vector<AnyVolume> volumes = {
        Scb{Vec3(0, 0, 0), 3, Vec3(0.6, 0, 0.8), 1.2, -1.5}, Ball{Vec3(0.4, 2, 0.1), 0.3},
        Obb{Vec3(-0.4, 1.8, 0.1), orbit_axes(20, 30), Vec3(0.2, 0.3, 0.1)}};
    Picture picture = picture_of(volumes, 160, 120, GetParam());
    picture.panes[0].camera = orbit_camera(0, 0, Vec3(0, 0.1, 0), 0.1, false, 70);
    picture.panes[0].camera.near_distance = 0.01;
    picture.panes[0].camera.far_distance = 10;
    const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
    expect_same_ids(picture, *rendering.ids);
    for (const std::uint32_t id : rendering.ids->ids) ASSERT_NE(id, 0u);
}

TEST_P(RayCast, AgreesForScenesOfAnyScale) {
    for (const double scale : {1e-20, 1e-6, 1e6, 1e60}) {
        std::vector<AnyVolume> volumes = {
            Scb{Vec3(0, 0, 0), scale, Vec3(0.6, 0, 0.8), 0.3 * scale, -0.2 * scale},
            Ball{Vec3(2 * scale, 0, 0), scale}};
        draw_and_compare(picture_of(volumes, 120, 90, GetParam()));
    }
}

/// From every side, far off and close, through the eye, and along the view axis, which is a plane
/// that some rays do not meet.
std::vector<FacePlane> planes_through(const Vec3& center, const Camera& camera) {
    std::vector<FacePlane> planes;
    for (int i = 0; i < 6; ++i) {
        const Vec3 n = orbit_axes(i * 61.0 + 7, i * 31.0 - 75).col(2);
        planes.push_back({n, dot(n, center) + 0.3 * (i % 3)});
    }
    const Vec3 right = camera.axes.col(0), backward = camera.axes.col(2);
    planes.push_back({right, dot(right, center) + 0.01});
    planes.push_back({-right, -dot(right, camera.position)});
    planes.push_back({backward, dot(backward, center) + 0.2});
    planes.push_back({-backward, -dot(backward, center) + 0.2});
    return planes;
}

TEST_P(RayCast, AgreesOnWhatAClippingPlaneLeaves) {
    const std::vector<AnyVolume> volumes = assorted_volumes();
    Picture picture = picture_of(volumes, 160, 120, GetParam());
    for (const bool orthographic : {false, true}) {
        Camera& camera = picture.panes[0].camera;
        camera =
            fit_camera(orbit_axes(-20, 50), support_of(volumes), {4.0 / 3, 0.04, orthographic, 30});
        for (const FacePlane& plane : planes_through(center_of(support_of(volumes)), camera)) {
            camera.clip = plane;
            SCOPED_TRACE(testing::Message() << plane.normal.transpose() << " " << plane.offset);
            draw_and_compare(picture);
        }
    }
}

TEST_P(RayCast, AgreesOnWhatAClippingPlaneLeavesAnEyeInside) {
    const std::vector<AnyVolume> volumes = {Scb{Vec3(0, 0, 0), 3, Vec3(0.6, 0, 0.8), 1.2, -1.5}};
    Picture picture = picture_of(volumes, 160, 120, GetParam());
    Camera& camera = picture.panes[0].camera;
    camera = orbit_camera(0, 0, Vec3(0, 0.1, 0), 0.1, false, 70);
    camera.near_distance = 0.01;
    camera.far_distance = 10;
    for (const FacePlane& plane : planes_through(Vec3(0.4, 1.9, 0.1), camera)) {
        camera.clip = plane;
        SCOPED_TRACE(testing::Message() << plane.normal.transpose() << " " << plane.offset);
        draw_and_compare(picture);
    }
}

// The rays of a column of pixels. They all lie on the side of the plane that is not drawn.
TEST_P(RayCast, AgreesWhereRaysAreNearlyParallelToTheClippingPlane) {
    const std::vector<AnyVolume> volumes = assorted_volumes();
    Picture picture = picture_of(volumes, 160, 120, GetParam());
    Camera& camera = picture.panes[0].camera;
    const double in_pixel = GetParam() == 4 ? 0.25 : 0.5,
                 right = in_pixel * 2 * tan_half_fov(camera) / picture.height;
    for (const double slope : {1e-8, 1e-6, 1e-5, -1e-8, -1e-6, -1e-5}) {
        const Vec3 n = (camera.axes * Vec3(1, 0, right + slope)).normalized();
        camera.clip = FacePlane{n, dot(n, camera.position) - 0.05 * camera.far_distance};
        draw_and_compare(picture);
    }
}

// Their surfaces are meshes: beside the lines where a facet or a volume ends a pixel may differ.
// A ray of the reference that meets a convex volume takes a search.
constexpr int pixels_to_next = unless_sanitized(1, 5);

TEST_P(RayCast, AgreesOnConvexVolumesButForTheirFacets) {
    const auto at = [](auto volume, const Vec3& where) {
        return AnyVolume(placed(shape_of(volume), {orbit_axes(20, 35), where}));
    };
    KDop26 dop;
    for (std::size_t i = 0; i < dop.which.size(); ++i) {
        dop.lower[i] = i < 3 ? -1 : -1.2;
        dop.upper[i] = i < 3 ? 0.8 : 1.1;
    }
    const std::vector<AnyVolume> volumes = {
        at(dop, Vec3(0, 0, 0)),
        at(Rss{Vec3::Zero(), {Vec3(1, 0, 0), Vec3(0, 0.6, 0)}, 0.3}, Vec3(3, 0, 0)),
        at(Capsule{Vec3::Zero(), Vec3(0.4, 0.8, 0), 0.5}, Vec3(0, 0, 2.5)),
        Ball{Vec3(1.5, 0, 1.2), 0.6}};
    for (const bool inside : {false, true}) {
        Picture picture = picture_of(volumes, 240, 180, GetParam());
        if (inside) {
            picture.panes[0].camera = orbit_camera(0, 0, Vec3(0, 0.1, 0), 0.1, false, 70);
            picture.panes[0].camera.near_distance = 0.01;
            picture.panes[0].camera.far_distance = 10;
        }
        const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
        const double offset = GetParam() == 4 ? 0.25 : 0.5;
        int seen = 0, wrong = 0, covered = 0;
        for (int y = 0; y < picture.height; y += pixels_to_next)
            for (int x = 0; x < picture.width; x += pixels_to_next) {
                const std::uint32_t drawn = pixel(*rendering.ids, x, y);
                const Hit hit = cast(picture.panes[0], x + offset, y + offset);
                ++seen;
                covered += drawn != 0;
                wrong += hit.id != drawn;
            }
        EXPECT_GT(covered, seen / 10);
        EXPECT_LT(wrong, 0.006 * covered) << (inside ? "inside" : "outside");
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, RayCast, testing::Values(1, 4));

TEST(RayCastOrder, TheNearerVolumeHidesTheFartherWhateverTheOrder) {
    Drawing drawing;
    const Ball near_ball{Vec3(0, -3, 0), 1}, far_ball{Vec3(0, 3, 0), 1.5};
    for (const bool swapped : {false, true}) {
        const std::vector<AnyVolume> volumes = swapped
                                                   ? std::vector<AnyVolume>{far_ball, near_ball}
                                                   : std::vector<AnyVolume>{near_ball, far_ball};
        Picture picture = picture_of(volumes, 101, 101, 1);
        picture.panes[0].camera =
            fit_camera(orbit_axes(0, 0), support_of(volumes), {1, 0.04, false, 30});
        const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
        EXPECT_EQ(pixel(*rendering.ids, 50, 50), swapped ? 2u : 1u);
    }
}

/// The picture with that volume alone.
Picture only(const Picture& picture, std::size_t volume) {
    Picture result = picture;
    result.panes[0].volumes = {picture.panes[0].volumes[volume]};
    return result;
}

TEST(RayCastOrder, OfCoplanarDiscsTheHigherIdIsDrawnWhole) {
    Drawing drawing;
    for (const bool orthographic : {false, true})
        for (const double tilt : {0.0, 45.0, 70.0, 85.0}) {
            // The view is along y at elevation 0, so that the normal is tilted away from it.
            const Vec3 n = orbit_axes(20, tilt).col(2), u = orbit_axes(20, tilt).col(0);
            const std::vector<AnyVolume> volumes = {Scb{Vec3(0, 0, 0), 1, n, 0, 0},
                                                    Scb{0.2 * u, 1, n, 0, 0}};
            Picture picture = picture_of(volumes, 400, 300, 1);
            picture.panes[0].camera = fit_camera(orbit_axes(20, 0), support_of(volumes),
                                                 {4.0 / 3, 0.04, orthographic, 30});
            const IdImage both = *drawing.renderer.draw(picture, nullptr, true).ids;
            const IdImage second = *drawing.renderer.draw(only(picture, 1), nullptr, true).ids;
            int covered = 0, wrong = 0;
            for (std::size_t i = 0; i < both.ids.size(); ++i) {
                covered += second.ids[i] == 2;
                wrong += (both.ids[i] == 2) != (second.ids[i] == 2);
            }
            EXPECT_GT(covered, 1000);
            EXPECT_EQ(wrong, 0) << "tilt " << tilt << ", orthographic " << orthographic;
        }
}

TEST(RayCastOrder, ASmallGapOrdersDiscsAtAnyDepthRange) {
    // The ids speak for the rear one by 31 millionths of the distance; a little more outweighs
    // them.
    Drawing drawing;
    for (const bool orthographic : {false, true})
        for (const double near_distance : {1e-1, 1e-2, 1e-3})
            for (const double depth : {0.2, 1.0, 6.0, 9.9}) {
                const double gap = order_tolerance * depth;
                Picture picture = picture_of({Ball{}}, 100, 100, 1);
                Pane& pane = picture.panes[0];
                pane.camera = Camera{};  // looks along -z
                pane.camera.orthographic = orthographic;
                pane.camera.near_distance = near_distance;
                pane.camera.far_distance = 10;
                pane.camera.view_height = 2 * depth * tan_half_fov(pane.camera);
                const double r = 0.2 * depth;
                const Scb rear{Vec3(0, 0, -depth - gap), r, Vec3::UnitZ(), 0, 0};
                const Scb front{Vec3(0, 0, -depth), r, Vec3::UnitZ(), 0, 0};
                pane.volumes = {{rear, {1, 2, 3}, 31}, {front, {1, 2, 3}, 32}};
                const IdImage both = *drawing.renderer.draw(picture, nullptr, true).ids;
                const IdImage alone = *drawing.renderer.draw(only(picture, 1), nullptr, true).ids;
                EXPECT_EQ(pixel(alone, 50, 50), 32u);
                EXPECT_EQ(both, alone) << near_distance << ' ' << depth << ' ' << orthographic;
            }
}

TEST(RayCastOrder, NothingBeyondTheDepthRangeIsDrawn) {
    Drawing drawing;
    for (const bool orthographic : {false, true}) {
        Picture picture = picture_of({Ball{}}, 60, 60, 1);
        Pane& pane = picture.panes[0];
        pane.camera = Camera{};
        pane.camera.orthographic = orthographic;
        pane.camera.near_distance = 1;
        pane.camera.far_distance = 10;
        const auto ids_at = [&](double z) {
            pane.volumes = {{Scb{Vec3(0, 0, z), 0.5, Vec3::UnitZ(), 0, 0}, {1, 2, 3}, 1}};
            return pixel(*drawing.renderer.draw(picture, nullptr, true).ids, 30, 30);
        };
        EXPECT_EQ(ids_at(-10.0001), 0u);
        EXPECT_EQ(ids_at(-9.9999), 1u);
        EXPECT_EQ(ids_at(-1.0001), 1u);
        EXPECT_EQ(ids_at(-0.9999), 0u);
        EXPECT_EQ(ids_at(0), 0u);
        EXPECT_EQ(ids_at(5), 0u);
    }
}

TEST(RayCastOrder, VolumesWithoutSizeDrawNothing) {
    Drawing drawing;
    const std::vector<AnyVolume> volumes = {Ball{Vec3(0, 0, 0), 1}, Ball{Vec3(0, -1.5, 0), 0},
                                            Scb{Vec3(0, -1.5, 0.1), 0, Vec3::UnitZ(), 0, 0}};
    const Rendering rendering =
        drawing.renderer.draw(picture_of(volumes, 200, 150, 4), nullptr, true);
    for (const std::uint32_t id : rendering.ids->ids) ASSERT_LE(id, 1u);
}

}  // namespace
}  // namespace scb::render
