#include "render/renderer.h"

#include <cstdlib>
#include <optional>
#include <string>

#include "core/error.h"
#include "render/figures.h"
#include "render/font_face.h"
#include "render/gl_program.h"
#include "render/mesh_painter.h"
#include "render/render_target.h"
#include "tests/render/gl_fixture.h"

namespace scb {
namespace {

Mesh quad() {
    Mesh mesh;
    mesh.vertices = {Vec3(-1, 0, -1), Vec3(1, 0, -1), Vec3(1, 0, 1), Vec3(-1, 0, 1)};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

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

// A triangle behind a wall: faint where it is to show through, and without an id.
TEST(Renderer, ShowsTrianglesThroughWhatHidesThem) {
    Drawing drawing;
    Picture picture{80, 60, 1, {255, 255, 255}, {}};
    Pane& pane = picture.panes.emplace_back();
    pane.viewport = {0, 0, 80, 60};
    pane.camera = orbit_camera(0, 0, Vec3::Zero(), 5);
    MeshDraw wall, hidden;
    wall.mesh = hidden.mesh = drawing.renderer.upload(quad());
    wall.color = {200, 200, 200};
    wall.first_id = 10;
    hidden.color = {200, 0, 0};
    hidden.first_id = 20;
    hidden.pose.translation = Vec3(0, 1, 0);
    pane.meshes = {wall, hidden};
    const Rendering without = drawing.renderer.draw(picture, nullptr, true);
    pane.meshes[1].shown_through = {1};
    const Rendering with = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(with.ids, without.ids);
    // Triangle 1 is the upper left half of the quad.
    const auto at = [&](const Image& image, int x, int y) {
        const std::size_t i = 4 * static_cast<std::size_t>(y * 80 + x);
        return std::array<int, 3>{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
    };
    EXPECT_NE(at(with.image, 35, 25), at(without.image, 35, 25));
    EXPECT_GT(at(with.image, 35, 25)[0], at(with.image, 35, 25)[1] + 40);
    EXPECT_EQ(at(with.image, 45, 35), at(without.image, 45, 35));
    // Not where nothing hides it: the mesh itself is drawn there.
    pane.meshes.erase(pane.meshes.begin());
    const Rendering alone = drawing.renderer.draw(picture);
    pane.meshes[0].shown_through.clear();
    EXPECT_EQ(alone.image, drawing.renderer.draw(picture).image);
}

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

/// Makes a context in a new process, whose environment is as `prepare` leaves it; the exit status
/// says whether llvmpipe draws.
template <typename Prepare>
[[noreturn]] void make_context(GlBackend backend, Prepare prepare) {
    prepare();
    try {
        const Context context(backend);
        std::_Exit(context.info().renderer == "llvmpipe" ? 0 : 1);
    } catch (const GlError&) {
        std::_Exit(2);
    }
}

TEST(ContextDeathTest, DrawsWithLlvmpipeWhateverTheEnvironmentAsksFor) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const char* driver : {"zz", "softpipe"})
        EXPECT_EXIT(make_context(any_backend(), [&] { setenv("GALLIUM_DRIVER", driver, 1); }),
                    testing::ExitedWithCode(0), "^$");
}

TEST(ContextDeathTest, AFailingEglIsSilent) {
    if (!is_compiled_in(GlBackend::egl)) GTEST_SKIP() << "no EGL";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        make_context(GlBackend::egl, [] { setenv("LIBGL_DRIVERS_PATH", "/nonexistent", 1); }),
        testing::ExitedWithCode(2), "^$");
}

TEST(Renderer, SaysWhatFailedOnceThereIsAContext) {
    Drawing drawing;
    const Gl& gl = drawing.context.gl();
    EXPECT_THROW(GlProgram(gl, {"no shader"}, {"void main() {}"}), DrawError);
    EXPECT_THROW(RenderTarget(gl, 1 << 20, 8, true), DrawError);
    while (gl.GetError() != GL_NO_ERROR) {
    }
    gl.Enable(
        GL_TEXTURE_2D);  // no such thing in a core context: an error, as if drawing had failed
    EXPECT_THROW(drawing.renderer.draw(picture_of({Ball{}}, 20, 20, 1)), DrawError);
    EXPECT_NO_THROW(drawing.renderer.draw(picture_of({Ball{}}, 20, 20, 1)));
}

TEST(Renderer, AMeshHasAsManyCornersAsAnIntHolds) {
    EXPECT_EQ(corner_count(715'827'882), 2'147'483'646);
    EXPECT_THROW(corner_count(715'827'883), InputError);
}

TEST(Renderer, SaysWhatItIsWithoutMachineFacts) {
    Drawing drawing;
    const GlInfo& info = drawing.context.info();
    EXPECT_FALSE(info.version.empty());
    EXPECT_EQ(info.renderer.find("bits"), std::string::npos);
    EXPECT_EQ(info.version.find(' '), std::string::npos);
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

TEST(Renderer, TrianglesHaveIdsAndColorsOfTheirOwn) {
    Drawing drawing;
    const Mesh mesh = quad();
    Picture picture;
    picture.width = picture.height = 100;
    Pane pane;
    pane.viewport = {0, 0, 100, 100};
    MeshDraw draw;
    draw.mesh = drawing.renderer.upload(mesh);
    draw.triangle_colors = {{200, 0, 0}, {0, 0, 200}};
    draw.first_id = 7;
    pane.meshes.push_back(draw);
    pane.camera = fit_camera(orbit_axes(0, 0), support_of(mesh, draw.pose), {1, 0.04, true, 30});
    picture.panes.push_back(pane);
    for (const int samples : {1, 4}) {
        picture.samples = samples;
        const Rendering rendering = drawing.renderer.draw(picture, nullptr, true);
        EXPECT_EQ(pixel(*rendering.ids, 70, 80), 7u);
        EXPECT_EQ(pixel(*rendering.ids, 20, 30), 8u);
        EXPECT_EQ(pixel(*rendering.ids, 1, 1), 0u);
        EXPECT_GT(pixel(rendering.image, 70, 80).r, pixel(rendering.image, 70, 80).b);
        EXPECT_GT(pixel(rendering.image, 20, 30).b, pixel(rendering.image, 20, 30).r);
        EXPECT_EQ(pixel(rendering.image, 1, 1), picture.background);
    }
    picture.panes[0].meshes[0].dim = 1;
    EXPECT_EQ(pixel(drawing.renderer.draw(picture).image, 70, 80), picture.background);
    picture.panes[0].meshes[0].first_id = 0;
    EXPECT_EQ(pixel(*drawing.renderer.draw(picture, nullptr, true).ids, 70, 80), 0u);
}

TEST(Renderer, AFlatVolumeWinsOverTheMeshItLiesOn) {
    Drawing drawing;
    const Mesh mesh = quad();
    Picture picture = picture_of({Scb{Vec3(0, 0, 0), 0.5, Vec3::UnitY(), 0, 0}}, 200, 200, 1);
    MeshDraw draw;
    draw.mesh = drawing.renderer.upload(mesh);
    draw.first_id = 100;
    picture.panes[0].meshes.push_back(draw);
    for (const bool orthographic : {false, true})
        for (const double azimuth : {0.0, 50.0, 80.0, 85.0}) {
            Pane& pane = picture.panes[0];
            pane.meshes = {draw};
            pane.camera = fit_camera(orbit_axes(azimuth, 20), support_of(mesh, draw.pose),
                                     {1, 0.04, orthographic, 30});
            const IdImage both = *drawing.renderer.draw(picture, nullptr, true).ids;
            pane.meshes.clear();
            const IdImage alone = *drawing.renderer.draw(picture, nullptr, true).ids;
            EXPECT_GT(std::count(alone.ids.begin(), alone.ids.end(), 1u), 200);
            for (std::size_t i = 0; i < alone.ids.size(); ++i)
                ASSERT_EQ(both.ids[i] == 1, alone.ids[i] == 1) << azimuth << ", pixel " << i;
        }
}

TEST(Renderer, AMeshAndASegmentAreOrderedByASmallGapAtAnyDepthRange) {
    Drawing drawing;
    Mesh plane = quad();
    for (Vec3& v : plane.vertices)
        v = 4 * Vec3(v[0], v[2], 0);  // faces the camera, far beyond the view
    Picture picture = picture_of({Ball{}}, 100, 100, 1);
    Pane& pane = picture.panes[0];
    MeshDraw draw;
    draw.mesh = drawing.renderer.upload(plane);
    draw.first_id = 100;
    pane.meshes = {draw};
    for (const bool orthographic : {false, true})
        for (const double near_distance : {1e-1, 1e-2, 1e-3})
            for (const double depth : {1.0, 6.0}) {
                pane.camera = Camera{};  // looks along -z
                pane.camera.orthographic = orthographic;
                pane.camera.near_distance = near_distance;
                pane.camera.far_distance = 10;
                const auto id_with_mesh_at = [&](double nearer) {
                    pane.meshes[0].pose.translation = Vec3(0, 0, -depth + nearer * depth);
                    return pixel(*drawing.renderer.draw(picture, nullptr, true).ids, 50, 50);
                };
                pane.segments.clear();
                pane.volumes = {{Scb{Vec3(0, 0, -depth), 0.2, Vec3::UnitZ(), 0, 0}, {}, 31}};
                EXPECT_EQ(id_with_mesh_at(4e-5), 31u) << near_distance << ' ' << depth;
                EXPECT_GE(id_with_mesh_at(4.5e-5), 100u) << near_distance << ' ' << depth;
                pane.volumes.clear();
                pane.segments = {{Vec3(-0.1, 0, -depth), Vec3(0.1, 0, -depth), {}, 9, 4, false}};
                EXPECT_EQ(id_with_mesh_at(6.7e-5), 9u) << near_distance << ' ' << depth;
                EXPECT_GE(id_with_mesh_at(7.3e-5), 100u) << near_distance << ' ' << depth;
            }
}

TEST(Renderer, MeshesAndSegmentsEndAtTheDepthRange) {
    // The floor z = -1 and a line along it, which reach from behind the eye to beyond the far
    // plane.
    Drawing drawing;
    Mesh floor = quad();
    for (Vec3& v : floor.vertices) v = Vec3(100 * v[0], 100 * v[2], -1);
    Picture picture = picture_of({Ball{}}, 200, 200, 1);
    Pane& pane = picture.panes[0];
    pane.volumes.clear();
    MeshDraw draw;
    draw.mesh = drawing.renderer.upload(floor);
    draw.first_id = 100;
    for (const bool line : {false, true})
        for (const bool orthographic : {false, true}) {
            pane.meshes.clear();
            pane.segments.clear();
            if (line)
                pane.segments = {{Vec3(0, -100, -1), Vec3(0, 100, -1), {}, 9, 3, false}};
            else
                pane.meshes = {draw};
            // Orthographic from above at an angle, so that the floor is no line.
            pane.camera =
                orbit_camera(0, orthographic ? 45 : 0, Vec3(0, 0, 0), 1, orthographic, 90);
            pane.camera.position = Vec3(0, 0, 0);
            pane.camera.view_height = 20;
            pane.camera.near_distance = 2;
            pane.camera.far_distance = 8;
            const IdImage ids = *drawing.renderer.draw(picture, nullptr, true).ids;
            // Where points of the floor's middle line at the two depths are in the picture.
            const double s = std::sqrt(0.5);
            const auto row = [&](double depth) {
                // Orthographic: depth = (y - z) s with z = -1.
                const double y = orthographic ? depth / s - 1 : depth;
                return project(pane.camera, Vec3(0, y, -1), 200, 200)[1];
            };
            const double low = std::max(row(2), row(8)), high = std::min(row(2), row(8));
            const double slack = line ? 3 : 1;  // pixels: a line's ends reach out by half its width
            for (int y = 0; y < 200; ++y) {
                const double at = y + 0.5;
                if (at > high + slack && at < low - slack) {
                    ASSERT_NE(pixel(ids, 100, y), 0u) << y << ' ' << line << ' ' << orthographic;
                }
                if (at < high - slack || at > low + slack) {
                    ASSERT_EQ(pixel(ids, 100, y), 0u) << y << ' ' << line << ' ' << orthographic;
                }
            }
        }
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
}  // namespace scb
