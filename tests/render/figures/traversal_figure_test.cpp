#include "render/figures/traversal_figure.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "render/plots/icicle.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/overlay/overlay_fixture.h"

namespace scb::render {
namespace {

TraceHeader scb_header() {
    TraceHeader header;
    header.scene = "scene";
    header.bodies = {TraceBody{"left", {}}, TraceBody{"right", {}}};
    header.volume = VolumeKind::scb;
    return header;
}

/// A frame of these steps, with the counts that they have.
QueryTrace frame_of(const Steps& steps) {
    QueryTrace frame;
    frame.steps = steps;
    frame.found.n_v = steps.volumes.size();
    for (const Step& test : steps.volumes) {
        ++frame.found.stages[static_cast<std::size_t>(test.stage)];
        frame.found.depth = std::max(frame.found.depth, test.depth_a + test.depth_b);
    }
    for (const ItemStep& test : steps.items) {
        ++frame.found.n_p;
        if (test.hit) frame.found.pairs.push_back(test.items);
    }
    return frame;
}

/// Five tests: the roots, divided; a child rejected and one divided; below it triangles that meet
/// and a pair that is rejected.
QueryTrace small_frame() {
    return frame_of({{{{0, 0}, 0, 0, Stage::overlapping, no_step},
                      {{1, 0}, 1, 0, Stage::slab_cylinder, 0},
                      {{2, 0}, 1, 0, Stage::overlapping, 0},
                      {{2, 1}, 1, 1, Stage::overlapping, 2},
                      {{2, 2}, 1, 1, Stage::ball_slab, 2}},
                     {{{5, 7}, 3, true}}});
}

/// The tests of a pair whose nodes overlap down to `depth`, all of the others rejected: every
/// level has one of each.
QueryTrace staircase(int depth, Stage stage) {
    Steps steps;
    steps.volumes.push_back({{0, 0}, 0, 0, Stage::overlapping, no_step});
    for (int d = 1; d <= depth; ++d) {
        const auto node = static_cast<std::uint32_t>(2 * d);
        const auto level = static_cast<std::uint16_t>(d);
        steps.volumes.push_back({{node - 1, 0}, level, 0, stage, node - 2});
        steps.volumes.push_back({{node, 0}, level, 0, Stage::overlapping, node - 2});
    }
    return frame_of(steps);
}

/// A full tree of divisions, whose leaves are at one depth: of every 8 in the order of their tests
/// the first `apart` are rejected, the others have triangles that meet.
QueryTrace comb(int levels, std::size_t apart) {
    Steps steps;
    struct Node {
        std::uint32_t index;
        std::uint16_t depth;
    };
    std::vector<Node> pending = {{0, 0}};
    steps.volumes.push_back({{0, 0}, 0, 0, Stage::overlapping, no_step});
    std::uint32_t next = 1;
    std::size_t leaves = 0;
    while (!pending.empty()) {
        const Node node = pending.back();
        pending.pop_back();
        for (int child = 0; child < 2; ++child) {
            const auto depth = static_cast<std::uint16_t>(node.depth + 1);
            const bool leaf = depth == levels;
            const bool rejected = leaf && leaves++ % 8 < apart;
            steps.volumes.push_back({{next, 0},
                                     depth,
                                     0,
                                     rejected ? Stage::ball_ball : Stage::overlapping,
                                     node.index});
            if (!leaf) pending.push_back({next, depth});
            if (leaf && !rejected)
                steps.items.push_back(
                    {{next, 0}, static_cast<std::uint32_t>(steps.volumes.size() - 1), true});
            ++next;
        }
    }
    return frame_of(steps);
}

std::vector<EndingGroup> groups_of(const TraceHeader& header) {
    return ending_groups(endings_of(header.volume, header.options), light_theme);
}

Icicle icicle_of(const QueryTrace& frame, int columns, int rows) {
    const TraceHeader header = scb_header();
    return icicle(frame.steps, outcomes_of(header, frame), groups_of(header), columns, rows, 8);
}

std::string label_of(const IcicleRun& run) {
    if (run.group == IcicleRun::divided) return "divided";
    return std::string(groups_of(scb_header())[run.group].label);
}

TEST(Icicle, OfASmallQueryByHand) {
    const Icicle icicle = icicle_of(small_frame(), 500, 100);
    EXPECT_EQ(icicle.rows, 3);
    EXPECT_EQ(icicle.depths_per_row, 1);
    std::vector<std::string> runs;
    for (const IcicleRun& run : icicle.runs)
        runs.push_back(std::to_string(run.row) + ": " + std::to_string(run.begin) + "-" +
                       std::to_string(run.end) + " " + label_of(run) + " " +
                       std::to_string(run.test));
    // Children below the left end of their pair, in the order of their tests.
    const std::vector<std::string> expected = {
        "0: 0-500 divided 0", "1: 0-100 slab A, cylinder B 1", "1: 100-400 divided 2",
        "2: 100-200 triangles meet 3", "2: 200-300 ball A, slab B 4"};
    EXPECT_EQ(runs, expected);
}

TEST(Icicle, RunsAndStacksOfARowDoNotOverlapAndStayInside) {
    for (const int columns : {1, 7, 100, 683})
        for (const QueryTrace& frame :
             {small_frame(), comb(9, 3), staircase(50, Stage::slab_ball)}) {
            const Icicle icicle = icicle_of(frame, columns, 1000);
            std::vector<std::tuple<int, int, int>> parts;
            for (const IcicleRun& run : icicle.runs)
                parts.emplace_back(run.row, run.begin, run.end);
            for (const IcicleStack& stack : icicle.stacks)
                parts.emplace_back(stack.row, stack.begin, stack.end);
            std::sort(parts.begin(), parts.end());
            int before = -1, free = 0;
            for (const auto& [row, begin, end] : parts) {
                if (row != before) free = 0;
                EXPECT_GE(begin, free);
                EXPECT_GT(end, begin);
                EXPECT_LE(end, columns);
                before = row;
                free = end;
            }
            EXPECT_EQ(before + 1, icicle.rows);
            EXPECT_EQ(before, frame.found.depth);
        }
}

TEST(Icicle, NarrowTestsAreStackedInProportion) {
    // About 20 leaves in a column.
    for (const std::size_t apart : {1u, 2u, 6u, 7u}) {
        const QueryTrace frame = comb(13, apart);
        const Icicle icicle = icicle_of(frame, 400, 100);
        std::size_t rejected = 0, meeting = 0;
        for (const IcicleStack& stack : icicle.stacks) {
            if (stack.row != 13) continue;
            EXPECT_EQ(stack.end - stack.begin, 8);
            EXPECT_EQ(stack.tests, stack.groups[0] + stack.groups[6]);
            // Every block has what all of them have: no block is a matter of chance.
            EXPECT_NEAR(8.0 * stack.groups[0] / stack.tests, static_cast<double>(apart), 0.4);
            rejected += stack.groups[0];
            meeting += stack.groups[6];
        }
        EXPECT_EQ(rejected, 1024 * apart);
        EXPECT_EQ(meeting, 1024 * (8 - apart));
        for (const IcicleRun& run : icicle.runs) EXPECT_LT(run.row, 8);
    }
    EXPECT_EQ(groups_of(scb_header())[0].label, "ball A, ball B");
    EXPECT_EQ(groups_of(scb_header())[6].label, "triangles meet");
}

TEST(Icicle, APartBeginsAtItsDepth) {
    QueryTrace frame = small_frame();
    for (Step& test : frame.steps.volumes) test.depth_a += 5;
    const Icicle icicle = icicle_of(frame, 500, 100);
    EXPECT_EQ(icicle.first_depth, 5);
    EXPECT_EQ(icicle.rows, 3);
}

TEST(Icicle, SaysWhetherItHasNumbersAndStacks) {
    const TraceHeader header = scb_header();
    const auto drawn = [&](const QueryTrace& frame, int height) {
        Overlay overlay;
        overlay.begin();
        FigureStyle style;
        style.unit = 20;
        return draw_icicle(overlay, {0, 0, 700, height}, frame.steps, outcomes_of(header, frame),
                           groups_of(header), style);
    };
    EXPECT_TRUE(drawn(small_frame(), 400).numbers);
    EXPECT_FALSE(drawn(small_frame(), 400).stacks);
    EXPECT_FALSE(drawn(small_frame(), 20).numbers);
    EXPECT_TRUE(drawn(comb(13, 3), 400).stacks);
    // As deep as castings go.
    EXPECT_TRUE(drawn(staircase(41, Stage::ball_ball), 450).numbers);
}

TEST(Icicle, DepthsShareARowWhereTheyAreTooMany) {
    const QueryTrace frame = staircase(400, Stage::ball_ball);
    for (const auto& [rows, most, per_row] :
         {std::tuple(401, 401, 1), {201, 400, 2}, {201, 201, 2}, {1, 1, 401}}) {
        const Icicle icicle = icicle_of(frame, 50, most);
        EXPECT_EQ(icicle.rows, rows);
        EXPECT_EQ(icicle.depths_per_row, per_row);
    }
}

TEST(Icicle, OfNothingIsEmpty) {
    const Icicle icicle = icicle_of(QueryTrace{}, 100, 100);
    EXPECT_EQ(icicle.rows, 0);
    EXPECT_TRUE(icicle.runs.empty());
}

TEST(ShortCount, HasAtMostFourCharacters) {
    const std::vector<std::pair<std::uint64_t, std::string>> expected = {{0, "0"},
                                                                         {999, "999"},
                                                                         {1000, "1k"},
                                                                         {1049, "1.0k"},
                                                                         {9999, "9.9k"},
                                                                         {12345, "12k"},
                                                                         {999'999, "999k"},
                                                                         {1'000'000, "1M"},
                                                                         {1'250'000, "1.2M"},
                                                                         {45'000'000'000, "45G"}};
    for (const auto& [count, text] : expected) EXPECT_EQ(short_count(count), text);
}

// ------------------------------------------------------------------------------------- pictures

Image drawn(Drawing& drawing, const TraversalFigure& figure, const TraceHeader& header,
            const QueryTrace& frame, int width, int height) {
    Overlay overlay;
    const Picture picture = compose(figure, header, frame, width, height, overlay);
    return drawing.renderer.draw(picture, &overlay).image;
}

std::map<std::uint32_t, int> colors_of(const Image& image) {
    std::map<std::uint32_t, int> counts;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Rgba8 c = pixel(image, x, y);
            ++counts[static_cast<std::uint32_t>(c.r << 16 | c.g << 8 | c.b)];
        }
    return counts;
}

int count_in(const std::map<std::uint32_t, int>& counts, Rgba8 c) {
    const auto at = counts.find(static_cast<std::uint32_t>(c.r << 16 | c.g << 8 | c.b));
    return at == counts.end() ? 0 : at->second;
}

TEST(TraversalFigure, AreasAreProportionalToTests) {
    Drawing drawing;
    TraversalFigure figure;
    figure.matrix = false;
    for (const Theme* theme : {&light_theme, &dark_theme}) {
        figure.theme = theme;
        const auto counts =
            colors_of(drawn(drawing, figure, scb_header(), small_frame(), 1280, 720));
        // One test each: a fifth of the width by a row; the swatches of the legend are the same.
        const int one = count_in(counts, ending_color(Stage::triangles_meet, *theme));
        EXPECT_GT(one, 240 * 30);
        for (const Stage stage : {Stage::slab_cylinder, Stage::ball_slab})
            EXPECT_NEAR(count_in(counts, ending_color(stage, *theme)), one, one / 50);
        // Two that are divided, of 5 tests and of 3; less the digits and the swatch.
        EXPECT_NEAR(count_in(counts, divided_color(*theme)), 8 * one, one / 4);
    }
}

TEST(TraversalFigure, SaysThatNothingOverlaps) {
    Drawing drawing;
    const QueryTrace none = frame_of({{{{0, 0}, 0, 0, Stage::ball_ball}}, {}});
    const auto counts = colors_of(drawn(drawing, {}, scb_header(), none, 1280, 720));
    EXPECT_GT(count_in(counts, light_theme.accent), 50);
    // The only test is as wide as all tests.
    EXPECT_GT(count_in(counts, ending_color(Stage::ball_ball, light_theme)), 600 * 30);
    const auto with_pairs = colors_of(drawn(drawing, {}, scb_header(), small_frame(), 1280, 720));
    // Its accent is the color of triangles that meet, which fills a rectangle instead.
    EXPECT_GT(count_in(with_pairs, light_theme.accent), 100 * 30);
}

TEST(TraversalFigure, DrawsOnlyWhatIsAskedFor) {
    Drawing drawing;
    for (const MatrixMeasure measure : {MatrixMeasure::tests, MatrixMeasure::share}) {
        TraversalFigure figure;
        figure.measure = measure;
        figure.icicle = false;
        const auto matrix =
            colors_of(drawn(drawing, figure, scb_header(), small_frame(), 640, 480));
        // Edges of letters may have the color.
        EXPECT_LT(count_in(matrix, divided_color(light_theme)), 50);
        // Of 5 tests 2 are rejected; the roots are not.
        const Rgba8 roots = viridis(0);
        EXPECT_GT(count_in(matrix, roots), 500);
        figure.icicle = true;
        figure.matrix = false;
        const auto icicle =
            colors_of(drawn(drawing, figure, scb_header(), small_frame(), 640, 480));
        EXPECT_LT(count_in(icicle, roots), 50);
        EXPECT_GT(count_in(icicle, divided_color(light_theme)), 5000);
    }
}

TEST(TraversalFigure, LeavesTheMarginsFree) {
    Drawing drawing;
    TraceHeader header = scb_header();
    header.bodies[0].name = std::string(60, 'W');
    TraversalFigure figure;
    figure.title = "a scene with a name that is far too long for the width · SCB · traversal";
    figure.subtitle = "frame 250 of 0 to 499, test symmetric, descent by radius";
    for (const auto& [width, height] : {std::pair(1280, 720),
                                        {640, 480},
                                        {720, 1280},
                                        {320, 240},
                                        {320, 480},
                                        {1000, 300},
                                        {600, 600}})
        for (const QueryTrace& frame : {small_frame(), comb(9, 3), staircase(900, Stage::slab_ball),
                                        staircase(0, Stage::slab_ball)}) {
            const Image image = drawn(drawing, figure, header, frame, width, height);
            const int margin = 6;
            const auto [inside, outside] =
                inside_and_outside(image, {margin, margin, width - 2 * margin, height - 2 * margin},
                                   light_theme.background);
            EXPECT_GT(inside, 500);
            EXPECT_EQ(outside, 0) << width << "x" << height << ", " << frame.found.n_v;
        }
}

}  // namespace
}  // namespace scb::render
