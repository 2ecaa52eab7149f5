#include "render/plots/section_plot.h"

#include <cmath>

#include "core/explain/exact_overlap.h"
#include "core/explain/pair_explanation.h"
#include "render/figures/explain_layout.h"
#include "render/overlay/clip.h"
#include "render/plots/section_cut.h"
#include "render/plots/slack_chart.h"
#include "scb/overlap.h"
#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"
#include "tests/render/overlay/rects.h"

namespace scb::render {
namespace {

// Directions that are parallel to a millionth count as parallel.
constexpr double invisible = 1e-5;

#ifdef SCB_SANITIZED
constexpr int many = 200;
#else
constexpr int many = 5000;
#endif

double area_of(const ScreenPolygon& polygon) {
    double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ScreenPosition &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        area += (p.x * q.y - q.x * p.y) / 2;
    }
    return std::abs(area);
}

TEST(Clip, LeavesWhatIsInHalfPlanesAndDiscs) {
    const PixelRect rect = {10, 20, 400, 300};
    const ScreenPolygon all = polygon_of(rect);
    EXPECT_EQ(area_of(all), 400 * 300);
    EXPECT_NEAR(area_of(clipped(all, HalfPlane{{1, 0}, 110})), 100 * 300, 1e-6);
    EXPECT_NEAR(area_of(clipped(all, HalfPlane{{0, -1}, -220})), 400 * 100, 1e-6);
    EXPECT_TRUE(clipped(all, HalfPlane{{1, 0}, 5}).empty());
    EXPECT_NEAR(area_of(clipped(all, ScreenCircle{{210, 170}, 100}, rect)), 31415.9, 3);
    // A quarter, and discs so large that they have a straight edge here, near and far away.
    EXPECT_NEAR(area_of(clipped(all, ScreenCircle{{10, 20}, 200}, rect)), 31415.9, 3);
    for (const double r : {1e4, 1e6, 1e9})
        EXPECT_NEAR(area_of(clipped(all, ScreenCircle{{210 - r, 170}, r}, rect)), 200 * 300,
                    3e6 / r + 10);
    EXPECT_TRUE(clipped(all, ScreenCircle{{1e6, 0}, 10}, rect).empty());
    EXPECT_TRUE(clipped(all, ScreenCircle{{900, 170}, 100}, rect).size() < 3 ||
                area_of(clipped(all, ScreenCircle{{900, 170}, 100}, rect)) < 1);
}

TEST(Clip, CutsLinesAtTheRectangle) {
    const PixelRect rect = {0, 0, 100, 100};
    const auto parts = clipped(
        std::vector<ScreenPosition>{{-50, 50}, {50, 50}, {50, 150}, {90, 150}, {90, 50}}, rect);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].size(), 3u);
    EXPECT_EQ(parts[0].front().x, 0);
    EXPECT_EQ(parts[0].back().y, 100);
    EXPECT_EQ(parts[1].front().y, 100);
    EXPECT_TRUE(clipped(std::vector<ScreenPosition>{{-5, -5}, {-1, 200}}, rect).empty());
}

struct ExplainedPair {
    AnyVolume a, b;
    PairExplanation found;
    OverlapOptions options;
};

ExplainedPair random_explained(Random& random, int i) {
    const auto& tests = all_overlap_tests();
    const ScbPair pair = random_scb_pair(
        random, scb_pair_families[static_cast<std::size_t>(i) % scb_pair_families.size()]);
    const OverlapOptions options{tests[static_cast<std::size_t>(i) % tests.size()], 0.7};
    const Placement placed = placement(pair.b_to_a, reach(pair.a), reach(pair.b));
    return {pair.a, seen_from_a(pair.b, placed), explain(pair.a, pair.b, placed, options), options};
}

std::optional<Vec3> common_point(const PairExplanation& found) {
    if (found.certificate.contact != Contact::overlapping) return std::nullopt;
    return found.certificate.point;
}

TEST(SectionPlane, ShowsTheLengthsOfTheStep) {
    Random random(5);
    int through_common_point = 0;
    for (int i = 0; i < many; ++i) {
        const ExplainedPair pair = random_explained(random, i);
        const Vec3 to_b = center(pair.b) - center(pair.a);
        for (const OverlapStep& step : pair.found.steps.steps) {
            const SectionPlane plane =
                section_plane(pair.a, pair.b, step, common_point(pair.found));
            EXPECT_NEAR(dot(cross(plane.right, plane.up), plane.front), 1, 1e-12);
            EXPECT_NEAR(dot(plane.up, to_b), step.reach_a + step.reach_b + step.slack, 1e-10);
            EXPECT_GE(dot(plane.right, to_b), -1e-12);
            EXPECT_FALSE(plane.words.empty());
            if (step.stage == Stage::slab_cylinder || step.stage == Stage::cylinder_slab) {
                // Both normals lie in it, so that silhouettes and cylinders are true.
                EXPECT_NEAR(dot(plane.front, std::get<Scb>(pair.a).n), 0, invisible);
                EXPECT_NEAR(dot(plane.front, std::get<Scb>(pair.b).n), 0, invisible);
            } else if (const auto point = common_point(pair.found);
                       point &&
                       (step.stage == Stage::slab_ball || step.stage == Stage::ball_slab)) {
                // One plane, through the common point.
                EXPECT_NEAR(dot(plane.front, *point), plane.before_a, invisible);
                EXPECT_NEAR(dot(plane.front, Vec3(*point - to_b)), plane.before_b, invisible);
                ++through_common_point;
            }
        }
    }
    EXPECT_GT(through_common_point, many / 2);
}

// What a drawing says is in both must be.
TEST(SectionCut, HoldsTheCommonPoint) {
    Random random(6);
    for (int i = 0; i < many; ++i) {
        const ExplainedPair pair = random_explained(random, i);
        const auto point = common_point(pair.found);
        if (!point) continue;
        const OverlapStep& step = pair.found.steps.steps[pair.found.steps.closest()];
        const SectionPlane plane = section_plane(pair.a, pair.b, step, point);
        const Vec3 to_b = center(pair.b) - center(pair.a);
        const SectionCut cuts[] = {
            section_cut(pair.a, Vec3::Zero(), plane, plane.before_a, body_a_color),
            section_cut(pair.b, to_b, plane, plane.before_b, body_b_color)};
        for (const SectionCut& cut : cuts) {
            const double x = dot(plane.right, *point) - cut.x, y = dot(plane.up, *point) - cut.y,
                         height = cut.nx * x + cut.ny * y;
            EXPECT_LE(std::sqrt(x * x + y * y), cut.r + invisible) << plane.words;
            EXPECT_LE(height, cut.e + invisible) << plane.words;
            EXPECT_GE(height, cut.f - invisible) << plane.words;
        }
    }
}

TEST(SectionPlot, StaysInItsRectangle) {
    Random random(7);
    Drawing drawing;
    Overlay overlay;
    const PixelRect rect = {60, 50, 220, 130}, chart = {60, 190, 220, 60};
    for (int i = 0; i < 60; ++i) {
        const ExplainedPair pair = random_explained(random, i);
        SectionPlot plot;
        plot.a = pair.a;
        plot.b = pair.b;
        plot.step = pair.found.steps.steps[pair.found.steps.closest()];
        plot.plane = section_plane(pair.a, pair.b, plot.step, common_point(pair.found));
        plot.common_point = common_point(pair.found);
        const auto expect_inside = [&](const PixelRect& box) {
            const Picture picture = empty_picture(340, 260);
            const Image image = drawing.renderer.draw(picture, &overlay).image;
            const auto [inside, outside] = inside_and_outside(image, box, picture.background);
            EXPECT_GT(inside, 100) << i;
            EXPECT_EQ(outside, 0) << i << plot.plane.words << plot.step.formula;
        };
        overlay.begin();
        draw_section_plot(overlay, rect, plot, light_theme, 13);
        expect_inside(rect);
        overlay.begin();
        draw_slack_chart(overlay, chart, {&pair.found.steps, light_theme.accent}, light_theme, 13);
        expect_inside(chart);
    }
}

bool within(const PixelRect& inner, const PixelRect& outer) {
    return inner.x >= outer.x && inner.y >= outer.y &&
           inner.x + inner.width <= outer.x + outer.width &&
           inner.y + inner.height <= outer.y + outer.height;
}

TEST(ExplainLayout, PartsLieInThePictureAndApart) {
    Random random(8);
    const ExplainedPair pair = random_explained(random, 0);
    const Obb box{Vec3::Zero(), Mat3::Identity(), Vec3(1, 1, 1)};
    const PairExplanation of_boxes = explain(box, box, placement(Pose{}, 2, 2));
    for (const bool boxes : {false, true})
        for (const auto& [width, height] : {std::pair{320, 240},
                                            {640, 480},
                                            {1280, 720},
                                            {1920, 1080},
                                            {480, 800},
                                            {320, 2000},
                                            {4000, 240}}) {
            ExplainFigure figure;
            figure.a = boxes ? AnyVolume(box) : pair.a;
            figure.b = boxes ? AnyVolume(box) : pair.b;
            figure.kind = boxes ? VolumeKind::obb : VolumeKind::scb;
            figure.found = boxes ? &of_boxes : &pair.found;
            const ExplainLayout layout = explain_layout(width, height, figure);
            std::vector<PixelRect> parts = {layout.heading, layout.view, layout.steps,
                                            layout.verdict};
            EXPECT_EQ(layout.section.width > 0, height > 240) << width << 'x' << height;
            if (layout.section.width > 0) parts.push_back(layout.section);
            EXPECT_TRUE(within(layout.view_box(), {0, 0, width, height}));
            for (std::size_t i = 0; i < parts.size(); ++i) {
                EXPECT_TRUE(within(parts[i], {0, 0, width, height})) << width << 'x' << height << i;
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_TRUE(apart(parts[i], parts[k])) << width << 'x' << height << i << k;
            }
        }
}

}  // namespace
}  // namespace scb::render
