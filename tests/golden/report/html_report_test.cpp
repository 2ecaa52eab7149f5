#include "golden/report/html_report.h"

#include <gtest/gtest.h>

#include "core/platform/output_file.h"
#include "render/files/image_file.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

class HtmlReport : public testing::Test {
  protected:
    HtmlReport() {
        failed.name = "pairs";
        failed.verdict = Verdict::different;
        failed.cause = "Body B moved: 0.02 along x.";
        failed.message = "These differ: 2 counts.";
        failed.lines = {"12 pairs only in the baseline."};
        render::Image image{4, 3, std::vector<std::uint8_t>(48, 255)};
        write_file_whole(folder.path / "before.png", render::encode_png(image));
        for (const int x : {0, 3})
            render::set_pixel(image, x, 1, {static_cast<std::uint8_t>(100 * x), 0, 0, 255});
        write_file_whole(folder.path / "after.png", render::encode_png(image));
        failed.picture = {"before.png", "after.png", ""};
        failed.colors.emplace();
        failed.colors->box = {0, 1, 4, 2};
        failed.focus = {3, 1, 4, 2};
    }
    std::string page() const {
        SuiteResult result;
        result.cases = {failed};
        return report_html(result, folder.path);
    }
    /// Where the page has this; each must be there.
    static std::size_t place_of(const std::string& page, const std::string& text) {
        const std::size_t at = page.find(text, page.find("<article"));
        EXPECT_NE(at, std::string::npos) << text;
        return at;
    }

    const TemporaryFolder folder;
    CaseResult failed;
};

TEST_F(HtmlReport, HasTheCauseThenThePicturesThenTheFindings) {
    failed.counts = {{"frames/0/n_v", 5, 6}};
    const std::string all = page();
    const std::size_t cause = place_of(all, failed.cause), picture = place_of(all, "<img "),
                      message = place_of(all, failed.message),
                      line = place_of(all, failed.lines[0]), count = place_of(all, "n_v");
    EXPECT_LT(cause, picture);
    EXPECT_LT(picture, message);
    EXPECT_LT(message, line);
    EXPECT_LT(line, count);
    failed.cause.clear();
    EXPECT_EQ(page().find("class=\"cause\""), std::string::npos);
}

TEST_F(HtmlReport, FoldsManyLinesAway) {
    failed.lines.assign(10, "a line");
    EXPECT_EQ(page().find("more lines"), std::string::npos);
    failed.lines.push_back("the last");
    const std::string all = page();
    EXPECT_LT(place_of(all, "<summary>3 more lines</summary>"), place_of(all, "the last"));
}

TEST_F(HtmlReport, ZoomsToTheSceneAndListsItsPixels) {
    const std::string all = page();
    EXPECT_NE(all.find("data-box=\"3 1 4 2\""), std::string::npos);
    EXPECT_NE(all.find(">(3, 1)<"), std::string::npos);
    EXPECT_EQ(all.find(">(0, 1)<"), std::string::npos) << "in the panel";
}

TEST_F(HtmlReport, RingsSmallChangesInTheDifferenceAlone) {
    const render::Image before{100, 50, std::vector<std::uint8_t>(4 * 100 * 50, 200)};
    render::Image after = before;
    render::set_pixel(after, 9, 4, {0, 0, 0, 255});
    for (int x = 50; x < 90; ++x) render::set_pixel(after, x, 40, {0, 0, 0, 255});
    write_file_whole(folder.path / "before.png", render::encode_png(before));
    write_file_whole(folder.path / "after.png", render::encode_png(after));
    write_file_whole(folder.path / "difference.png",
                     render::encode_png(difference_picture(before, after)));
    failed.picture.difference = "difference.png";
    const std::string all = page();
    const std::size_t ring = place_of(all, "<span class=\"ring\"");
    EXPECT_EQ(ring,
              place_of(all, "<span class=\"ring\" style=\"left: 9.5%; top: 9%; --size: 1%\">"));
    EXPECT_GT(ring, place_of(all, "<figure class=\"difference\""));
    EXPECT_EQ(all.find("class=\"ring\"", ring + 20), std::string::npos) << "a long line is seen";
}

TEST_F(HtmlReport, SaysOfAHashOnlyThatItChanged) {
    failed.counts = {{"frames/0/pairs_hash", 3726636963351340, 8635169824371806}};
    const std::string all = page();
    EXPECT_NE(all.find("<td></td><td></td><td class=\"change\">changed</td>"), std::string::npos);
    for (const char* number : {"3,726", "8,635", "4,908"})
        EXPECT_EQ(all.find(number), std::string::npos) << number;
}

}  // namespace
}  // namespace scb::golden
