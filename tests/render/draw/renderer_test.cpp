#include "render/draw/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "render/gl/gl_program.h"
#include "render/gl/render_target.h"
#include "render/overlay/font_face.h"
#include "render/overlay/scales.h"
#include "scb/error.h"
#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

/// Everything at once: opaque and translucent volumes, a mesh with edges, segments, two panes,
/// text.
struct Everything {
    Picture picture;
    Overlay overlay;

    Everything(Renderer& renderer, int samples) {
        std::vector<AnyVolume> volumes = assorted_volumes();
        picture = picture_of(volumes, 300, 200, samples);
        Pane& pane = picture.panes[0];
        for (std::size_t i = 0; i < pane.volumes.size(); i += 3) pane.volumes[i].color.a = 120;
        MeshDraw mesh;
        mesh.mesh = renderer.upload(quad());
        mesh.edges = true;
        mesh.first_id = 1000;
        mesh.pose.translation = Vec3(3, 2, 1);
        pane.meshes.push_back(mesh);
        pane.segments.push_back({Vec3(0, 0, 0), Vec3(8, 2, 1), {200, 0, 0}, 2000, 2, true});
        Pane inset = pane;
        inset.viewport = {190, 120, 100, 70};
        inset.background = Rgba8{230, 230, 230};
        picture.panes.push_back(inset);
        FigureStyle style;
        style.unit = 13;
        overlay.text(5, 5, "τ = e − f ≤ 2r · Δ", {15, FontWeight::bold, {20, 20, 20}, Align::left});
        draw_stacked_bar(overlay, {5, 150, 60, 8},
                         std::vector<BarPart>{{body_a_color, 1}, {body_b_color, 2}}, 4);
        draw_color_bar(overlay, {100, 170, 80, 8}, viridis, "",
                       std::vector<Tick>{{0, "0"}, {1, "1"}}, style);
    }
};

TEST(Renderer, TheSamePictureGivesTheSameBytes) {
    for (const int samples : {1, 4}) {
        Drawing drawing;
        Everything scene(drawing.renderer, samples);
        const Rendering first = drawing.renderer.draw(scene.picture, &scene.overlay, true);
        drawing.renderer.draw(picture_of({Ball{Vec3(0, 0, 0), 1}}, 64, 64, 4));  // leaves no trace
        const Rendering again = drawing.renderer.draw(scene.picture, &scene.overlay, true);
        EXPECT_EQ(first.image, again.image);
        EXPECT_EQ(first.ids, again.ids);

        Drawing other;
        Everything same(other.renderer, samples);
        const Rendering elsewhere = other.renderer.draw(same.picture, &same.overlay, true);
        EXPECT_EQ(first.image, elsewhere.image);
        EXPECT_EQ(first.ids, elsewhere.ids);
    }
}

TEST(Renderer, DrawsThePanesOfLargePicturesOneByOne) {
    Drawing drawing;
    Everything scene(drawing.renderer, 4);
    Picture large = scene.picture;
    large.width = 1500;
    large.height = 1000;
    large.panes[0].viewport = {100, 700, 300, 200};
    large.panes[1].viewport = {350, 750, 100, 70};  // over a part of the first
    // The same panes, where all are drawn at once.
    Picture small = large;
    small.width = 500;
    small.height = 300;
    small.panes[0].viewport = {100, 50, 300, 200};
    small.panes[1].viewport = {350, 100, 100, 70};
    const Rendering of_large = drawing.renderer.draw(large, nullptr, true),
                    of_small = drawing.renderer.draw(small, nullptr, true);
    int different = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 500; ++x)
            different += pixel(of_large.image, x, y + 650) != pixel(of_small.image, x, y) ||
                         pixel(*of_large.ids, x, y + 650) != pixel(*of_small.ids, x, y);
    // Elsewhere in the target, corners may be rounded to another 256th of a pixel.
    EXPECT_LT(different, 20);
    EXPECT_EQ(pixel(of_large.image, 1400, 20), large.background);
    EXPECT_EQ(pixel(*of_large.ids, 1400, 20), 0u);
}

TEST(Renderer, AsksForTheContentsOfAPaneWhenItIsDrawn) {
    Drawing drawing;
    Everything scene(drawing.renderer, 1);
    const Rendering whole = drawing.renderer.draw(scene.picture, nullptr, true);
    for (Pane& pane : scene.picture.panes) {
        pane.add_contents = [volumes = std::move(pane.volumes)](Pane& drawn) {
            drawn.volumes = volumes;
        };
        pane.volumes.clear();
    }
    const Rendering later = drawing.renderer.draw(scene.picture, nullptr, true);
    EXPECT_EQ(later.image, whole.image);
    EXPECT_EQ(later.ids, whole.ids);
}

TEST(Renderer, KeepsItsShadersAndNothingElseForTheNextContext) {
    std::optional<Rendering> first;
    std::vector<const ContextPlatform*> used;
    for (int i = 0; i < 3; ++i) {
        Drawing drawing;
        Everything scene(drawing.renderer, 4);
        const Rendering found = drawing.renderer.draw(scene.picture, &scene.overlay, true);
        if (!first) first = found;
        EXPECT_EQ(found.image, first->image);
        EXPECT_EQ(found.ids, first->ids);
        // Contexts that are there at the same time are two.
        const Drawing other;
        used = {&drawing.context.platform(), &other.context.platform()};
        EXPECT_NE(used[0], used[1]);
        drawing.context.make_current();
    }
    const Drawing again;
    EXPECT_NE(std::find(used.begin(), used.end(), &again.context.platform()), used.end());
}

TEST(Renderer, BothBackEndsDrawTheSame) {
    if (!is_compiled_in(GlBackend::osmesa) || !is_compiled_in(GlBackend::egl))
        GTEST_SKIP() << "one back end only";
    for (const int samples : {1, 4}) {
        std::optional<Rendering> first;
        for (const GlBackend backend : {GlBackend::osmesa, GlBackend::egl}) {
            std::optional<Context> context;
            try {
                context.emplace(backend);
            } catch (const GlError& error) {
                GTEST_SKIP() << error.what();
            }
            EXPECT_EQ(context->info().backend, to_string(backend));
            Renderer renderer(*context);
            Everything scene(renderer, samples);
            Rendering rendering = renderer.draw(scene.picture, &scene.overlay, true);
            if (!first) {
                first = std::move(rendering);
            } else {
                EXPECT_EQ(first->image, rendering.image);
                EXPECT_EQ(first->ids, rendering.ids);
            }
        }
    }
}

TEST(Renderer, SaysWhatFailedOnceThereIsAContext) {
    Drawing drawing;
    const Gl& gl = drawing.context.gl();
    EXPECT_THROW(GlProgram(gl, {"no shader"}, {"void main() {}"}), DrawError);
    EXPECT_THROW(RenderTarget(gl, 1 << 20, 8, RenderTarget::Use::views), DrawError);
    while (gl.GetError() != GL_NO_ERROR) {
    }
    gl.Enable(
        GL_TEXTURE_2D);  // no such thing in a core context: an error, as if drawing had failed
    EXPECT_THROW(drawing.renderer.draw(picture_of({Ball{}}, 20, 20, 1)), DrawError);
    EXPECT_NO_THROW(drawing.renderer.draw(picture_of({Ball{}}, 20, 20, 1)));
}

TEST(Renderer, RefusesSizesThatItCannotDraw) {
    Drawing drawing;
    for (const auto& [width, height] : {std::pair{0, 0}, {0, 10}, {-1, 5}, {100000, 100000}}) {
        Picture picture;
        picture.width = width;
        picture.height = height;
        EXPECT_THROW(drawing.renderer.draw(picture), InputError);
    }
    for (const int samples : {1, 4}) {
        const int largest = drawing.renderer.largest_size(samples);
        Picture strip;
        strip.samples = samples;
        strip.height = 2;
        strip.width = largest;
        EXPECT_EQ(drawing.renderer.draw(strip).image.width, largest);
        strip.width = largest + 1;
        try {
            drawing.renderer.draw(strip);
            ADD_FAILURE();
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(std::to_string(largest) + " pixels"),
                      std::string::npos)
                << error.what();
        }
    }
    Picture picture;
    picture.samples = 3;
    EXPECT_THROW(drawing.renderer.draw(picture), InputError);
    picture.samples = 1;
    picture.panes.resize(1);
    picture.panes[0].viewport = {1200, 0, 100, 100};
    EXPECT_THROW(drawing.renderer.draw(picture), InputError);
}

TEST(Renderer, TranslucentVolumesShowWhatIsBehindThem) {
    Drawing drawing;
    const std::vector<AnyVolume> volumes = {Ball{Vec3(0, -2, 0), 1}, Ball{Vec3(0, 2, 0), 0.5}};
    Picture picture = picture_of(volumes, 101, 101, 1);
    Pane& pane = picture.panes[0];
    pane.camera = fit_camera(orbit_axes(0, 0), support_of(volumes), {1, 0.04, true, 30});
    pane.volumes[0].color = {0, 0, 255, 60};
    pane.volumes[1].color = {255, 0, 0};
    const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(*rendering.ids, 50, 50), 1u);  // the nearest surface, though translucent
    const Rgba8 over_ball = pixel(rendering.image, 50, 50);
    EXPECT_GT(over_ball.r, over_ball.b);
    std::reverse(pane.volumes.begin(), pane.volumes.end());
    EXPECT_EQ(drawing.renderer.draw(picture).image, rendering.image);
    pane.volumes[1].color.a = 0;
    EXPECT_EQ(pixel(*drawing.renderer.draw(picture, nullptr, true).ids, 50, 50), 2u);
}

TEST(Renderer, SegmentsHaveTheirWidthAndStayInFront) {
    Drawing drawing;
    Picture picture = picture_of({Ball{Vec3(0, 0, 0), 1}}, 101, 101, 1);
    Pane& pane = picture.panes[0];
    pane.camera =
        fit_camera(orbit_axes(0, 0), support_of(std::vector<AnyVolume>{Ball{Vec3(0, 0, 0), 1}}),
                   {1, 0.04, true, 30});
    const Segment segment{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), {255, 0, 0}, 9, 3, true};
    pane.segments = {segment};
    Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
    int rows = 0;
    for (int y = 0; y < 101; ++y) rows += pixel(*rendering.ids, 50, y) == 9;
    EXPECT_EQ(rows, 3);
    pane.segments[0].on_top = false;
    rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(*rendering.ids, 50, 50), 1u);
}

TEST(Renderer, LinesInWhichSurfacesMeetAreDashedWhereTheyAreHidden) {
    Drawing drawing;
    // A line behind the ball. Its ends are seen through a translucent ball.
    Picture picture =
        picture_of({Ball{Vec3(0, 0, 0), 1}, Ball{Vec3(0, -0.2, 0), 1.9}}, 201, 101, 1);
    Pane& pane = picture.panes[0];
    pane.volumes[1].color.a = 60;
    pane.camera =
        fit_camera(orbit_axes(0, 0), support_of(std::vector<AnyVolume>{Ball{Vec3(0, 0, 0), 2.2}}),
                   {2, 0.04, true, 30});
    const Rgba8 red{255, 0, 0}, gray{90, 90, 90};
    pane.segments = {{Vec3(-1.6, 0, 0), Vec3(1.6, 0, 0), red, 9, 3, false, gray}};
    const Image image = drawing.renderer.draw(picture).image;
    const auto rows_of = [&](int x, Rgba8 color) {
        int rows = 0;
        for (int y = 0; y < 101; ++y) rows += pixel(image, x, y) == color;
        return rows;
    };
    int dashes = 0;
    for (int x = 92; x < 108; ++x) {
        EXPECT_EQ(rows_of(x, red), 0);
        EXPECT_LE(rows_of(x, gray), 1);
        dashes += rows_of(x, gray);
    }
    EXPECT_EQ(dashes, 10);
    EXPECT_EQ(rows_of(70, gray), 0);
    EXPECT_EQ(rows_of(70, red), 3);
}

// The sides of a line in a narrow valley lie behind its slopes.
TEST(Renderer, LinesInWhichSurfacesMeetAreSeenBetweenSteepSlopes) {
    Drawing drawing;
    for (const double step : {0.5, 0.8}) {
        Picture picture =
            picture_of({Ball{Vec3(-step, 0, 0), 1}, Ball{Vec3(step, 0, 0), 1}}, 101, 101, 1);
        Pane& pane = picture.panes[0];
        pane.camera =
            fit_camera(orbit_axes(0, 0), support_of(std::vector<AnyVolume>{Ball{Vec3(0, 0, 0), 2}}),
                       {1, 0.04, true, 30});
        const double y = -std::sqrt(1 - step * step);
        const Rgba8 red{255, 0, 0};
        pane.segments = {{Vec3(0, y, -0.1), Vec3(0, y, 0.1), red, 9, 3, false, Rgba8{90, 90, 90}}};
        const Image image = drawing.renderer.draw(picture).image;
        int columns = 0;
        for (int x = 0; x < 101; ++x) columns += pixel(image, x, 50) == red;
        EXPECT_EQ(columns, 3) << step;
    }
}

TEST(Renderer, HatchedVolumesHaveTwoTonesAndTheirIds) {
    Drawing drawing;
    for (const AnyVolume& volume : std::vector<AnyVolume>{
             Ball{Vec3(0, 0, 0), 1}, Obb{Vec3(0, 0, 0), Mat3::Identity(), Vec3(1, 1, 1)},
             two_slabs(Vec3(0, 0, 0), 1, Mat3::Identity(), 0.5, -0.5, 0.5, -0.5)}) {
        Picture picture = picture_of({volume}, 101, 101, 1);
        picture.panes[0].volumes[0].color = {140, 140, 140};
        const Rendering plain = drawing.renderer.draw(picture, nullptr, true);
        picture.panes[0].volumes[0].hatched = true;
        const Rendering hatched = drawing.renderer.draw(picture, nullptr, true);
        EXPECT_EQ(plain.ids, hatched.ids);
        int darker = 0;
        double light_before = 0, light_after = 0;
        for (int x = 40; x < 61; ++x) {
            const int light = pixel(plain.image, x, 50).g, after = pixel(hatched.image, x, 50).g;
            darker += after < light - 20;
            // Of light, see light.glsl.
            light_before += light * light;
            light_after += after * after;
        }
        // Two pixels of seven.
        EXPECT_EQ(darker, 6);
        EXPECT_NEAR(light_after / light_before, 1, 0.04);
    }
}

/// Orthographic, from -y; a square about the origin of this height fills the view.
Camera from_the_front(double height) {
    return fit_camera(orbit_axes(0, 0),
                      support_of(std::vector<AnyVolume>{Ball{Vec3(0, 0, 0), height / 2}}),
                      {1, 0.04, true, 30});
}

Picture empty_picture() {
    Picture picture = picture_of({Ball{Vec3(0, 0, 0), 1}}, 101, 101, 1);
    picture.panes[0].volumes.clear();
    picture.panes[0].camera = from_the_front(4);
    return picture;
}

MeshDraw quad_at(MeshHandle handle, double y, Rgba8 color, std::uint32_t first_id) {
    MeshDraw mesh;
    mesh.mesh = handle;
    mesh.pose.translation = Vec3(0, y, 0);
    mesh.color = color;
    mesh.shading = 0;
    mesh.first_id = first_id;
    return mesh;
}

TEST(Renderer, AMeshShinesThroughWhatHidesItAndStaysAsItIsElsewhere) {
    Drawing drawing;
    Picture picture = empty_picture();
    Pane& pane = picture.panes[0];
    const MeshHandle handle = drawing.renderer.upload(quad());
    const Rgba8 blue{0, 0, 255}, red{255, 0, 0};
    // The blue square is before the right half of the red one.
    pane.meshes = {quad_at(handle, 0.5, red, 100), quad_at(handle, 0, blue, 200)};
    pane.meshes[1].pose.translation = Vec3(1, 0, 0);
    const Rendering plain = drawing.renderer.draw(picture, nullptr, true);
    pane.meshes[0].shine_through = 0.4;
    for (const bool blue_first : {false, true}) {
        if (blue_first) std::swap(pane.meshes[0], pane.meshes[1]);
        const Rendering shining = drawing.renderer.draw(picture, nullptr, true);
        EXPECT_EQ(shining.ids, plain.ids);
        EXPECT_EQ(pixel(shining.image, 40, 50), red);
        const Rgba8 mixed = pixel(shining.image, 60, 50);
        EXPECT_NEAR(mixed.r, 0.4 * 255, 1);
        EXPECT_NEAR(mixed.b, 0.6 * 255, 1);
        EXPECT_EQ(pixel(shining.image, 85, 50), blue);
    }
    // Two that shine through keep the color of the nearer one.
    for (MeshDraw& mesh : pane.meshes) mesh.shine_through = 0.4;
    EXPECT_EQ(drawing.renderer.draw(picture).image, plain.image);
}

TEST(Renderer, AreasAreBeforeTheSurfaceThatTheyLieInAndBehindLinesInThem) {
    Drawing drawing;
    Picture picture = empty_picture();
    Pane& pane = picture.panes[0];
    const MeshHandle handle = drawing.renderer.upload(quad());
    const Rgba8 blue{0, 0, 255}, green{0, 255, 0}, black{0, 0, 0};
    pane.meshes = {quad_at(handle, 0, blue, 100)};
    pane.areas = {{{Vec3(-0.5, 0, -0.5), Vec3(0.5, 0, -0.5), Vec3(0.5, 0, 0.5), Vec3(-0.5, 0, 0.5)},
                   green,
                   300,
                   0.5}};
    pane.segments = {{Vec3(-0.5, 0, 0), Vec3(0.5, 0, 0), black, 400, 3}};
    Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(*rendering.ids, 50, 45), 300u);
    EXPECT_EQ(pixel(rendering.image, 50, 45), green);
    EXPECT_EQ(pixel(*rendering.ids, 50, 50), 400u);
    EXPECT_EQ(pixel(rendering.image, 30, 50), blue);
    // Behind the surface it shines through, and the surface keeps its ids.
    pane.meshes[0].pose.translation = Vec3(0, -0.5, 0);
    rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_GE(pixel(*rendering.ids, 50, 45), 100u);
    EXPECT_LE(pixel(*rendering.ids, 50, 45), 101u);
    EXPECT_NEAR(pixel(rendering.image, 50, 45).g, 128, 1);
    // A part behind the eye is cut off.
    pane.meshes.clear();
    pane.segments.clear();
    pane.camera.orthographic = false;
    pane.camera.position = Vec3(0, -1, 0);
    pane.camera.near_distance = 0.1;
    pane.camera.far_distance = 10;
    pane.areas[0].corners = {Vec3(-1, 3, -0.2), Vec3(1, 3, -0.2), Vec3(1, -3, -0.2),
                             Vec3(-1, -3, -0.2)};
    rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(*rendering.ids, 50, 95), 300u);
    EXPECT_EQ(pixel(*rendering.ids, 50, 40), 0u);
}

TEST(Renderer, ABackdropHidesNothing) {
    Drawing drawing;
    Picture picture = picture_of({Ball{Vec3(0, 3, 0), 1}}, 101, 101, 1);
    Pane& pane = picture.panes[0];
    MeshDraw mesh;
    mesh.mesh = drawing.renderer.upload(quad());
    mesh.first_id = 1000;
    pane.meshes = {mesh};
    // Seen from the side of the quad.
    pane.camera =
        fit_camera(orbit_axes(0, 0), support_of(std::vector<AnyVolume>{Ball{Vec3(0, 1.5, 0), 3}}),
                   {1, 0.04, true, 30});
    EXPECT_EQ(pixel(*drawing.renderer.draw(picture, nullptr, true).ids, 50, 50), 1000u);
    pane.meshes[0].backdrop = true;
    const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(*rendering.ids, 50, 50), 1u);
    // Beside the ball it is seen, without its ids.
    EXPECT_EQ(pixel(*rendering.ids, 36, 36), 0u);
    EXPECT_NE(pixel(rendering.image, 36, 36), picture.background);
}

TEST(Renderer, PanesAreClippedToTheirRectangles) {
    Drawing drawing;
    Picture picture = picture_of({Ball{Vec3(0, 0, 0), 1}}, 100, 100, 4);
    picture.panes[0].viewport = {60, 10, 30, 20};
    picture.panes[0].background = Rgba8{1, 2, 3};
    const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(rendering.image, 59, 15), picture.background);
    EXPECT_EQ(pixel(rendering.image, 60, 10), (Rgba8{1, 2, 3}));
    EXPECT_EQ(pixel(rendering.image, 89, 29), (Rgba8{1, 2, 3}));
    EXPECT_EQ(pixel(rendering.image, 90, 30), picture.background);
    EXPECT_EQ(pixel(*rendering.ids, 75, 20), 1u);
}

}  // namespace
}  // namespace scb::render
