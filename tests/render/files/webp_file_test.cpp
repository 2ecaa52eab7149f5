#include "render/files/webp_file.h"

#include <gtest/gtest.h>
#include <webp/demux.h>

#include <fstream>
#include <iterator>

#include "tests/temporary_folder.h"

namespace scb::render {
namespace {

constexpr int width = 64, height = 48;

Image frame_of(int i) {
    Image image{width, height, std::vector<std::uint8_t>(4 * width * height, 255)};
    for (std::size_t at = 0; at < image.rgba.size(); at += 4)
        image.rgba[at] = static_cast<std::uint8_t>(at / 64 + 30 * static_cast<std::size_t>(i));
    return image;
}

std::string made(const std::string& path, int frames, int rate) {
    WebpFile file(path, width, height, rate);
    for (int i = 0; i < frames; ++i) file.push(frame_of(i));
    EXPECT_EQ(file.frames(), static_cast<std::size_t>(frames));
    EXPECT_FALSE(std::filesystem::exists(path)) << "nothing is written before the end";
    file.finish();
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(WebpFile, HasAllFramesAsTheyWereAtTheirTimes) {
    TemporaryFolder folder;
    const std::string bytes = made(folder / "a.webp", 7, 30);
    EXPECT_EQ(bytes, made(folder / "b.webp", 7, 30)) << "the same bytes";
    const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
    WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
    ASSERT_NE(decoder, nullptr);
    WebPAnimInfo info;
    ASSERT_TRUE(WebPAnimDecoderGetInfo(decoder, &info));
    EXPECT_EQ(info.frame_count, 7U);
    EXPECT_EQ(info.loop_count, 0U) << "endless";
    // The time of a frame is its end.
    const int ends[] = {33, 67, 100, 133, 167, 200, 233};
    for (int i = 0; i < 7; ++i) {
        std::uint8_t* pixels = nullptr;
        int end = 0;
        ASSERT_TRUE(WebPAnimDecoderGetNext(decoder, &pixels, &end));
        EXPECT_EQ(std::vector<std::uint8_t>(pixels, pixels + 4 * width * height), frame_of(i).rgba);
        EXPECT_EQ(end, ends[i]);
    }
    WebPAnimDecoderDelete(decoder);
}

TEST(WebpFile, IsNotWrittenUnlessFinished) {
    TemporaryFolder folder;
    {
        WebpFile file(folder / "a.webp", width, height, 25);
        file.push(frame_of(0));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.webp"));
}

TEST(Animation, GoesByItsName) {
    EXPECT_TRUE(is_webp_name("a/b.webp"));
    EXPECT_FALSE(is_webp_name("a.webp/b.mp4"));
    TemporaryFolder folder;
    const auto file = animation_file(folder / "a.webp", width, height, 25, {});
    EXPECT_NE(dynamic_cast<WebpFile*>(file.get()), nullptr);
}

}  // namespace
}  // namespace scb::render
