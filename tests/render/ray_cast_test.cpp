#include <string>

#include "tests/render/cpu_caster.h"
#include "tests/render/gl_fixture.h"

namespace scb {
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

TEST(RayCastOrder, CoplanarDiscsDoNotMixPixelByPixel) {
    Drawing drawing;
    const Vec3 n = orbit_axes(20, 35).col(2);
    const std::vector<AnyVolume> volumes = {Scb{Vec3(0, 0, 0), 1, n, 0, 0},
                                            Scb{Vec3(0.2, 0.1, 0), 1, n, 0, 0}};
    std::vector<AnyVolume> coplanar = volumes;
    auto& second = std::get<Scb>(coplanar[1]);
    second.c -= dot(second.c, n) * n;
    const Rendering rendering =
        drawing.renderer.draw(picture_of(coplanar, 400, 300, 1), nullptr, true);
    // The one in front is drawn whole: its pixels in every row are contiguous.
    int runs = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 1; x < 400; ++x)
            runs += pixel(*rendering.ids, x, y) == 2 && pixel(*rendering.ids, x - 1, y) != 2;
    EXPECT_GT(runs, 0);
    EXPECT_LE(runs, 300);
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
}  // namespace scb
