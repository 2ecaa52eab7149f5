#include "render/draw/mesh_painter.h"

#include <algorithm>
#include <cmath>

#include "scb/error.h"
#include "tests/render/gl/gl_fixture.h"

namespace scb::render {
namespace {

// Some triangles of a mesh in a color of their own, before the whole mesh.
TEST(MeshPainter, OfWhatCoincidesTheFirstIsSeenAndFlatColorsAreTheirOwn) {
    Drawing drawing;
    Picture picture{80, 60, 1, {255, 255, 255}, {}};
    Pane& pane = picture.panes.emplace_back();
    pane.viewport = {0, 0, 80, 60};
    pane.camera = orbit_camera(0, 0, Vec3::Zero(), 5);
    MeshDraw whole, marked;
    whole.mesh = marked.mesh = drawing.renderer.upload(quad());
    whole.color = {200, 200, 200};
    marked.color = {200, 90, 0};
    marked.chosen = {1};
    marked.shading = 0;
    pane.meshes = {marked, whole};
    const Image image = drawing.renderer.draw(picture).image;
    // Triangle 1 is the upper left half of the quad.
    EXPECT_EQ(pixel(image, 35, 25), marked.color);
    const Rgba8 other = pixel(image, 45, 35);
    EXPECT_EQ(other.r, other.b);
    EXPECT_NE(other, whole.color);
}

TEST(MeshPainter, AMeshHasAsManyCornersAsAnIntHolds) {
    EXPECT_EQ(corner_count(715'827'882), 2'147'483'646);
    EXPECT_THROW(corner_count(715'827'883), InputError);
}

TEST(MeshPainter, TrianglesHaveIdsAndColorsOfTheirOwn) {
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
    // One of them alone, and in stripes.
    picture.panes[0].meshes[0].chosen = std::vector<std::uint32_t>{1};
    const Rendering one = drawing.renderer.draw(picture, nullptr, true);
    EXPECT_EQ(pixel(*one.ids, 70, 80), 0u);
    EXPECT_EQ(pixel(*one.ids, 20, 30), 8u);
    picture.panes[0].meshes[0].hatched = true;
    const Rendering striped = drawing.renderer.draw(picture);
    int darker = 0;
    for (int x = 20; x < 34; ++x)
        darker += pixel(striped.image, x, 30).b < pixel(one.image, x, 30).b - 20;
    EXPECT_GE(darker, 4);
    EXPECT_LE(darker, 7);
    picture.panes[0].meshes[0].chosen.reset();
    picture.panes[0].meshes[0].dim = 1;
    EXPECT_EQ(pixel(drawing.renderer.draw(picture).image, 70, 80), picture.background);
    picture.panes[0].meshes[0].first_id = 0;
    EXPECT_EQ(pixel(*drawing.renderer.draw(picture, nullptr, true).ids, 70, 80), 0u);
}

TEST(MeshPainter, AFlatVolumeWinsOverTheMeshItLiesOn) {
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

TEST(MeshPainter, AMeshAndASegmentAreOrderedByASmallGapAtAnyDepthRange) {
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

TEST(MeshPainter, MeshesAndSegmentsEndAtTheDepthRange) {
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

}  // namespace
}  // namespace scb::render
