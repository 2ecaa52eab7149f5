#include "golden/compare/comparison.h"

#include <gtest/gtest.h>

#include "core/platform/file_bytes.h"
#include "core/platform/output_file.h"
#include "golden/suite/baseline.h"
#include "render/files/image_file.h"
#include "render/overlay/figure_layout.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

render::Image picture(int width, int height, std::uint8_t green = 100) {
    render::Image image{width, height, {}};
    image.rgba.assign(static_cast<std::size_t>(4 * width * height), 255);
    render::set_pixel(image, 1, 2, {10, green, 30});
    return image;
}

render::IdImage id_picture(int width, int height, std::uint32_t id = 7) {
    render::IdImage image{width, height, {}};
    image.ids.assign(static_cast<std::size_t>(width * height), 0);
    image.ids[3] = id;
    return image;
}

/// A case whose baseline is what the run made.
class CaseComparison : public testing::Test {
  protected:
    CaseComparison() {
        golden.name = "case";
        for (const TemporaryFolder* folder : {&baselines, &candidates}) {
            folder->write("case.counts.json", R"({"frames": {"0": {"n_v": 5, "pairs": 2}}})");
            write_file_whole(folder->path / "case.ids.png", render::encode_png(id_picture(8, 6)));
            write_file_whole(folder->path / "case.png", render::encode_png(picture(8, 6)));
        }
    }
    CaseResult compare() const {
        return compare_case(golden, {baselines.path, candidates.path, report.path});
    }
    void draw(const TemporaryFolder& folder, const char* name, const render::Image& image) const {
        write_file_whole(folder.path / name, render::encode_png(image));
    }
    void expect_said(const CaseResult& result, const std::string& words) const {
        EXPECT_NE(result.message.find(words), std::string::npos) << result.message;
    }
    bool in_report(const std::string& name) const {
        return !name.empty() && fs::is_regular_file(report.path / name);
    }

    GoldenCase golden;
    const TemporaryFolder baselines, candidates, report;
};

TEST_F(CaseComparison, FindsNothingWhereNothingDiffers) {
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::same);
    EXPECT_EQ(result.message, "");
    EXPECT_EQ(result.variant, 1);
    EXPECT_TRUE(fs::is_empty(report.path));
}

TEST_F(CaseComparison, SaysWhatDiffersInEach) {
    candidates.write("case.counts.json", R"({"frames": {"0": {"n_v": 6, "pairs": 2}}})");
    write_file_whole(candidates.path / "case.ids.png", render::encode_png(id_picture(8, 6, 9)));
    draw(candidates, "case.png", picture(8, 6, 101));
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::different);
    ASSERT_EQ(result.counts.size(), 1u);
    EXPECT_EQ(result.counts[0].place, "frames/0/n_v");
    ASSERT_TRUE(result.ids && result.colors);
    EXPECT_EQ(result.ids->pixels, 1u);
    EXPECT_EQ(result.colors->largest, 1);
    EXPECT_EQ(result.message,
              "These differ: 1 count; the owners of 1 pixel at (3, 0); the "
              "colors of 1 pixel at (1, 2), by up to 1 of 255.");
    EXPECT_TRUE(in_report(result.picture.baseline) && in_report(result.picture.candidate) &&
                in_report(result.picture.difference) && in_report(result.id_picture.candidate));
}

TEST_F(CaseComparison, LooksAtTheSceneAndNotAtThePanelUnlessOnlyThatChanged) {
    golden.counts = golden.ids = false;
    const render::Image before{320, 240, std::vector<std::uint8_t>(320 * 240 * 4, 255)};
    render::Image after = before;
    const render::PixelRect panel = render::figure_layout(320, 240).panel;
    render::set_pixel(after, panel.x + 5, panel.y + 5, {0, 0, 0, 255});
    draw(baselines, "case.png", before);
    draw(candidates, "case.png", after);
    const PixelBox digit{panel.x + 5, panel.y + 5, panel.x + 6, panel.y + 6};
    EXPECT_EQ(compare().focus, digit);
    render::set_pixel(after, 60, 100, {254, 255, 255, 255});
    draw(candidates, "case.png", after);
    const CaseResult result = compare();
    EXPECT_EQ(result.focus, (PixelBox{60, 100, 61, 101}));
    EXPECT_EQ(result.colors->pixels, 2u);
    golden.panel = false;
    EXPECT_EQ(compare().focus, compare().colors->box);
    golden.panel = true;
    // A plot is all of its picture.
    golden.run = GoldenRun::traversal;
    EXPECT_EQ(compare().focus, compare().colors->box);
}

TEST_F(CaseComparison, AnUnreadableFileHidesNoOtherDifference) {
    candidates.write("case.counts.json", R"({"frames": {"0": {"n_v": 6, "pairs": 3}}})");
    baselines.write("case.ids.png", "no picture");
    draw(candidates, "case.png", picture(8, 6, 90));
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::could_not_run);
    EXPECT_EQ(result.counts.size(), 2u);
    ASSERT_TRUE(result.colors);
    EXPECT_EQ(result.colors->largest, 10);
    expect_said(result, "2 counts");
    expect_said(result, "the colors of 1 pixel");
    expect_said(result, "case.ids.png");
}

TEST_F(CaseComparison, UnreadableCountsHideNoPicture) {
    baselines.write("case.counts.json", "{\"frames\": {");
    draw(candidates, "case.png", picture(8, 6, 90));
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::could_not_run);
    EXPECT_TRUE(result.colors);
    expect_said(result, "case.counts.json");
}

TEST_F(CaseComparison, AnUnreadableAcceptedPictureHidesNoDifferenceFromOthers) {
    baselines.write("case.2.png", "no picture");
    EXPECT_EQ(compare().verdict, Verdict::same);
    draw(candidates, "case.png", picture(8, 6, 90));
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::could_not_run);
    EXPECT_TRUE(result.colors);
    expect_said(result, "case.2.png");
}

TEST_F(CaseComparison, AnotherSizeHidesNoCounts) {
    candidates.write("case.counts.json", R"({"frames": {"0": {"n_v": 6, "pairs": 2}}})");
    draw(candidates, "case.png", picture(9, 6));
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::size_differs);
    EXPECT_EQ(result.counts.size(), 1u);
    expect_said(result, "The baseline's picture has 8x6 pixels, and the run made 9x6.");
    expect_said(result, "1 count");
}

TEST_F(CaseComparison, AcceptsAnyOfThePictures) {
    draw(baselines, "case.2.png", picture(8, 6, 50));
    draw(candidates, "case.png", picture(8, 6, 50));
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::same);
    EXPECT_EQ(result.variant, 2);
}

TEST_F(CaseComparison, TakesTheToleranceOfTheCaseAndNoMore) {
    draw(candidates, "case.png", picture(8, 6, 103));
    golden.tolerance = {3, 0};
    EXPECT_EQ(compare().verdict, Verdict::same);
    golden.tolerance = {2, 0};
    EXPECT_EQ(compare().verdict, Verdict::different);
    golden.tolerance = {2, 1};
    EXPECT_EQ(compare().verdict, Verdict::same);
}

TEST_F(CaseComparison, WithoutABaselineLeavesTheCandidate) {
    for (const char* name : {"case.counts.json", "case.ids.png", "case.png"})
        fs::remove(baselines.path / name);
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::missing_baseline);
    EXPECT_TRUE(in_report(result.picture.candidate));
    EXPECT_EQ(result.picture.baseline, "");
}

TEST_F(CaseComparison, AFolderIsNoPicture) {
    fs::remove(baselines.path / "case.png");
    fs::create_directory(baselines.path / "case.png");
    const CaseResult result = compare();
    EXPECT_EQ(result.verdict, Verdict::new_output);
    expect_said(result, "case.png of the baseline is not a regular file");
}

TEST_F(CaseComparison, ComparesOnlyWhatTheCaseSays) {
    candidates.write("case.counts.json", R"({"frames": {}})");
    draw(candidates, "case.png", picture(8, 6, 0));
    golden.counts = golden.colors = false;
    EXPECT_EQ(compare().verdict, Verdict::same);
}

}  // namespace
}  // namespace scb::golden
