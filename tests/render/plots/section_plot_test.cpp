#include "render/plots/section_plot.h"

#include <cmath>

#include "core/explain/exact_overlap.h"
#include "core/explain/pair_explanation.h"
#include "render/figures/explain_figure.h"
#include "render/overlay/clip.h"
#include "render/overlay/figure_layout.h"
#include "render/plots/section_cut.h"
#include "render/plots/section_dimensions.h"
#include "render/plots/slack_chart.h"
#include "scb/overlap.h"
#include "tests/core/overlap/random_scb_pairs.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"
#include "tests/unless_sanitized.h"

namespace scb::render {
namespace {

// Directions that are parallel to a millionth count as parallel.
constexpr double invisible = 1e-5;

constexpr int many = unless_sanitized(5000, 200);

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

// Of Figure 9's kind: A's slab up to 0.5, B's corner just above it, far from A's ball.
SectionPlot tight_plot() {
    SectionPlot plot;
    const Scb a{Vec3::Zero(), 1, Vec3::UnitZ(), 0.5, -0.5};
    const double gap = 1e-3;
    const Vec3 n(0.6, 0, 0.8);
    const Scb b{Vec3(2, 0, 0.5 + gap + 0.3 * 0.8 + 0.6), 1, n, 0.3, -0.3};
    const Placement placed = placement(Pose{}, 4, 4);
    const PairExplanation found = explain(a, b, placed, {OverlapTest::symmetric, 0.7});
    plot.a = a;
    plot.b = b;
    plot.step = found.steps.steps[5];
    plot.plane = section_plane(plot.a, plot.b, plot.step, std::nullopt);
    return plot;
}

TEST(SectionPlot, ShowsBothBodiesBesideADetail) {
    const SectionPlot plot = tight_plot();
    ASSERT_EQ(plot.step.stage, Stage::slab_cylinder);
    EXPECT_NEAR(plot.step.slack, 1e-3, 1e-6);
    Drawing drawing;
    for (const auto& [width, detail] : {std::pair{700, true}, {300, false}}) {
        Overlay overlay;
        overlay.begin();
        EXPECT_EQ(draw_section_plot(overlay, {0, 0, width, 400}, plot, light_theme, 16), detail);
        const Picture picture = empty_picture(width, 400);
        const Image image = drawing.renderer.draw(picture, &overlay).image;
        // Filled with a part of their colors, the fourth of a ball and more.
        int of_a = 0, of_b = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Rgba8 p = pixel(image, x, y);
                of_a += p.b > p.r + 30;
                of_b += p.r > p.b + 30;
            }
        EXPECT_GT(of_a, 1500) << width;
        EXPECT_GT(of_b, 1500) << width;
    }
}

TEST(SectionDimensions, AddUpAsPrinted) {
    EXPECT_EQ(
        sum_texts({0.0932521, -0.0346664, -0.0466667, -0.0115470, 0.000371993}),
        (std::vector<std::string>{"0.093252", "−0.034666", "−0.046667", "−0.011547", "+0.000372"}));
    EXPECT_EQ(sum_texts({-0.125, -1.75, -0.625, -1.34e-7, -2.5}),
              (std::vector<std::string>{"−0.125", "−1.750", "−0.625", "0", "−2.500"}));
    // A digit more, where that is enough.
    EXPECT_EQ(sum_texts({0.104686, -0.0623397, -0.0816497, -0.039303}),
              (std::vector<std::string>{"0.10469", "−0.06234", "−0.08165", "−0.03930"}));
    EXPECT_EQ(sum_texts({1.0 / 3, 1.0 / 3, 1.0 / 3, 1}),
              (std::vector<std::string>{"0.334", "0.333", "0.333", "+1.000"}));
    EXPECT_EQ(sum_texts({1e60, -2e-9, 1e60}),
              (std::vector<std::string>{"1.00e+60", "−2.00e-09", "1.00e+60"}));
    EXPECT_EQ(sum_texts({0, 0, 0}), (std::vector<std::string>{"0", "0", "0"}));
    const auto value_of = [](std::string text) {
        if (text.starts_with("−")) text.replace(0, std::string("−").size(), "-");
        std::erase(text, ',');
        return std::stod(text);
    };
    Random random(9);
    for (int i = 0; i < 1000; ++i) {
        std::vector<double> numbers;
        double sum = 0, size = std::pow(10.0, static_cast<double>(random.below(9)) - 4);
        for (std::size_t k = 0; k < 2 + random.below(3); ++k) {
            numbers.push_back(size * (random.uniform() - 0.5));
            sum += numbers.back();
        }
        numbers.push_back(sum);
        const std::vector<std::string> texts = sum_texts(numbers);
        double printed = 0;
        for (std::size_t k = 0; k + 1 < texts.size(); ++k) {
            printed += value_of(texts[k]);
            EXPECT_NEAR(value_of(texts[k]), numbers[k], 0.011 * size) << texts[k];
        }
        EXPECT_NEAR(printed, value_of(texts.back()), 1e-9 * size);
    }
}

TEST(ExplainCamera, LooksAlongThePlaneBetweenDisjointVolumes) {
    Random random(10);
    int disjoint = 0;
    for (int i = 0; i < many / 20; ++i) {
        const ExplainedPair pair = random_explained(random, i);
        if (pair.found.certificate.contact != Contact::disjoint) continue;
        ++disjoint;
        ExplainFigure figure;
        figure.a = pair.a;
        figure.b = pair.b;
        figure.kind = VolumeKind::scb;
        figure.found = &pair.found;
        const Camera camera = explain_camera(figure, 1.5);
        EXPECT_TRUE(camera.orthographic);
        EXPECT_NEAR(dot(Vec3(camera.axes.col(2)), pair.found.certificate.direction), 0, 1e-9);
        EXPECT_NEAR(dot(Vec3(camera.axes.col(1)), pair.found.certificate.direction), 1, 1e-9);
    }
    EXPECT_GT(disjoint, 0);
}

bool within(const PixelRect& inner, const PixelRect& outer) {
    return inner.x >= outer.x && inner.y >= outer.y &&
           inner.x + inner.width <= outer.x + outer.width &&
           inner.y + inner.height <= outer.y + outer.height;
}

TEST(ExplainLayout, PartsLieInThePictureAndApart) {
    Random random(8);
    const ExplainedPair pair = random_explained(random, 0);
    Overlay overlay;
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
            const ExplainLayout layout = explain_layout(width, height, figure, overlay);
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

TEST(ExplainLayout, HasALineForASubtitleThatDoesNotFit) {
    Random random(8);
    const ExplainedPair pair = random_explained(random, 0);
    ExplainFigure figure;
    figure.a = pair.a;
    figure.b = pair.b;
    figure.kind = VolumeKind::scb;
    figure.found = &pair.found;
    figure.title = "a mesh with itself";
    figure.subtitle = "test symmetric";
    Overlay overlay;
    const PixelRect usual = explain_layout(640, 360, figure, overlay).heading;
    EXPECT_EQ(usual.height, figure_layout(640, 360).heading.height);
    figure.title += " and a name that is as long as names of CAD models are";
    figure.subtitle += ", frame 0, 86 volume tests wasted";
    const ExplainLayout layout = explain_layout(640, 360, figure, overlay);
    EXPECT_GT(layout.heading.height, usual.height);
    EXPECT_TRUE(apart(layout.heading, layout.view));
    overlay.begin();
    FigureLayout heading;
    heading.unit = layout.unit;
    heading.heading = layout.heading;
    draw_heading(overlay, heading, light_theme, figure.title, figure.subtitle);
    Drawing drawing;
    const Image image = drawing.renderer.draw(empty_picture(640, 360), &overlay).image;
    const PixelRect second = {layout.heading.x, layout.heading.y + title_size(layout.unit), 200,
                              layout.unit};
    EXPECT_GT(inside_and_outside(image, second, empty_picture(1, 1).background).first, 100);
}

// Of a volume in the other one: triangles of that may hide it.
TEST(ExplainFigure, OutlinesAVolumeThatTheOtherOneHolds) {
    Drawing drawing;
    for (const bool orthographic : {false, true})
        for (const double x : {0.2, 1.1}) {
            const Scb a{Vec3(x, 0, 0), 0.3, Vec3::UnitZ(), 0.1, -0.1},
                b{Vec3::Zero(), 1, Vec3::UnitZ(), 0.8, -0.8};
            const PairExplanation found = explain(a, b, placement(Pose{}, 2, 2), {});
            ExplainFigure figure;
            figure.a = a;
            figure.b = b;
            figure.kind = VolumeKind::scb;
            figure.found = &found;
            figure.orthographic = orthographic;
            Overlay overlay;
            Picture picture = compose(figure, 640, 480, 1, overlay);
            const PixelRect view = picture.panes[0].viewport;
            picture.panes.clear();
            const Image image = drawing.renderer.draw(picture, &overlay).image;
            int blue = 0;
            for (int y = view.y; y < view.y + view.height; ++y)
                for (int column = view.x; column < view.x + view.width; ++column) {
                    const Rgba8 p = pixel(image, column, y);
                    blue += p.b > p.r + 20;
                }
            if (x < 1)
                EXPECT_GT(blue, 100);
            else
                EXPECT_EQ(blue, 0);
        }
}

}  // namespace
}  // namespace scb::render
