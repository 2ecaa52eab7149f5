#include "render/files/image_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "core/platform/output_file.h"
#include "render/files/encode_queue.h"
#include "scb/error.h"
#include "tests/png_chunks.h"

namespace scb::render {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
  protected:
    ImageFile() {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = fs::temp_directory_path() / ("scb_image_file_" + name);
        fs::remove_all(folder);
        fs::create_directory(folder);
    }
    ~ImageFile() override { fs::remove_all(folder); }

    std::ptrdiff_t file_count() const { return std::distance(fs::directory_iterator(folder), {}); }

    fs::path folder;
};

Image gradient(bool opaque) {
    Image image{37, 23, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const int value : {7 * x, 11 * y, x * y, opaque ? 255 : 5 * x})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
    return image;
}

TEST_F(ImageFile, PicturesSurviveTheRoundTrip) {
    for (const bool opaque : {true, false}) {
        const Image image = gradient(opaque);
        write_file_whole(folder / "picture.png", encode_png(image));
        EXPECT_EQ(read_png(folder / "picture.png"), image);
    }
}

TEST_F(ImageFile, IdsSurviveTheRoundTrip) {
    const IdImage ids{3, 2, {0, 1, 0xFFFFFFFF, 0x01020304, 0x80000000, 255}};
    write_file_whole(folder / "ids.png", encode_png(ids));
    EXPECT_EQ(unpack_ids(read_png(folder / "ids.png")), ids);
}

TEST_F(ImageFile, SaysWhatItIsToldBesideThePixels) {
    const std::vector<PngText> texts = {{"Software", "scb 1"}, {"Scene", "ärm"}, {"Empty", ""}};
    const Image image = gradient(false);
    const IdImage ids{2, 1, {7, 8}};
    const auto text_of = [](const std::vector<std::uint8_t>& bytes) {
        return std::string(bytes.begin(), bytes.end());
    };
    for (const auto& [with, without] : {std::pair{encode_png(image, texts), encode_png(image)},
                                        {encode_png(ids, texts), encode_png(ids)}}) {
        EXPECT_EQ(png_texts(text_of(with)),
                  (std::map<std::string, std::string>{
                      {"Software", "scb 1"}, {"Scene", "ärm"}, {"Empty", ""}}));
        EXPECT_EQ(png_without_texts(text_of(with)), text_of(without));
        EXPECT_TRUE(png_texts(text_of(without)).empty());
    }
    // What is not plain is UTF-8, which tEXt is not.
    const std::string whole = text_of(encode_png(image, texts));
    EXPECT_NE(whole.find("tEXtSoftware"), std::string::npos);
    EXPECT_NE(whole.find("iTXtScene"), std::string::npos);
    write_file_whole(folder / "picture.png", encode_png(image, texts));
    EXPECT_EQ(read_png(folder / "picture.png"), image);
    // As readers compute it that check it: over type and content.
    const std::string chunk = "tEXtSoftware" + std::string(1, '\0') + "scb 1";
    const std::size_t at = whole.find(chunk);
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        sum = sum << 8 | static_cast<unsigned char>(whole[at + chunk.size() + i]);
    EXPECT_EQ(sum, 0xb0bae3a6u);
}

/// The error about a refused file, after the name of the file.
std::string words_of(const fs::path& file) {
    try {
        read_png(file);
        return "nothing";
    } catch (const InputError& error) {
        const std::string name = "\"" + file.string() + "\" is ", sentence = error.what();
        return sentence.starts_with(name) ? sentence.substr(name.size()) : sentence;
    }
}

TEST_F(ImageFile, WhatIsNoPngIsRefused) {
    EXPECT_THROW(read_png(folder / "missing.png"), InputError);
    std::ofstream(folder / "text.png") << "not a picture";
    EXPECT_EQ(words_of(folder / "text.png"), "not a PNG file.");
    const std::vector<std::uint8_t> whole = encode_png(gradient(true));
    constexpr std::size_t end_chunk = 12;
    for (const std::size_t size : {whole.size() / 2, whole.size() - end_chunk}) {
        write_file_whole(folder / "cut.png", std::span(whole).first(size));
        EXPECT_EQ(words_of(folder / "cut.png"), "not a whole PNG file: it ends too early.") << size;
    }
    // Nobody writes into it, so reading would not end.
    ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
    EXPECT_THROW(read_png(folder / "pipe.png"), InputError);
}

TEST_F(ImageFile, MayBeDamagedInAWayThatTheDecoderHasNoWordsFor) {
    // A kind of block that does not exist.
    constexpr std::uint8_t wrong_block[] = {
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49,
        0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02,
        0x00, 0x00, 0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00, 0x07, 0x49, 0x44,
        0x41, 0x54, 0x78, 0x01, 0x07, 0x00, 0x00, 0x00, 0x00, 0xef, 0xad, 0x4a, 0xdd,
        0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    write_file_whole(folder / "block.png", wrong_block);
    // In each thread the decoder keeps the message of an earlier error.
    std::jthread([&] { EXPECT_THROW(read_png(folder / "block.png"), InputError); });
}

// The decoder reads on behind the end of the compressed data.
TEST_F(ImageFile, MayHaveCompressedDataWithoutAnEnd) {
    constexpr std::uint8_t endless[] = {
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00,
        0x00, 0x12, 0x16, 0xf1, 0x4d, 0x00, 0x00, 0x00, 0x14, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9c, 0x62, 0x60, 0x65, 0x63, 0xe7, 0x60, 0x80, 0xb3, 0x00, 0x02, 0x6c, 0x00, 0x49,
        0x02, 0x20, 0xa0, 0x0a, 0x73, 0x00, 0x00, 0x1a, 0x44, 0x41, 0x54, 0x78, 0x14, 0x49,
        0x44, 0x41, 0x54, 0x78, 0x9c, 0x62, 0x60, 0x65, 0x63, 0xe7, 0x60, 0x80, 0xb3, 0x00,
        0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    write_file_whole(folder / "endless.png", endless);
    EXPECT_EQ(words_of(folder / "endless.png"),
              "a damaged PNG file: it holds more than a picture of its size.");
}

TEST_F(ImageFile, OfOneColorIsSmall) {
    Image image{4000, 3000, {}};
    image.rgba.assign(std::size_t{4} * 4000 * 3000, 255);
    const std::vector<std::uint8_t> bytes = encode_png(image);
    EXPECT_LT(bytes.size(), image.rgba.size() / 500);
    write_file_whole(folder / "white.png", bytes);
    EXPECT_EQ(read_png(folder / "white.png"), image);
}

// The decoder's message has the name of an unknown chunk, in any characters.
TEST_F(ImageFile, IsRefusedOnOneLineOfPlainCharacters) {
    std::vector<std::uint8_t> bytes = encode_png(gradient(true));
    constexpr std::size_t data_chunk = 33;
    const std::uint8_t name[] = {0x0a, 0xff, 0x0d, 0x1b};
    std::copy(std::begin(name), std::end(name), bytes.begin() + data_chunk + 4);
    write_file_whole(folder / "chunk.png", bytes);
    const std::string words = words_of(folder / "chunk.png");
    EXPECT_TRUE(words.starts_with("a damaged PNG file: ")) << words;
    EXPECT_TRUE(std::all_of(words.begin(), words.end(), [](char c) {
        return c >= ' ' && c <= '~';
    })) << words;
}

// Two grey pixels of 16 bits, 0x8000 and 0x80ff: of 8 bits they would be the same.
TEST_F(ImageFile, OfAnotherDepthIsRefused) {
    constexpr std::uint8_t sixteen[] = {
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x10, 0x00, 0x00, 0x00,
        0x00, 0x81, 0xd9, 0xfc, 0x15, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9c, 0x63, 0x68, 0x60, 0x68, 0xf8, 0x0f, 0x00, 0x04, 0x04, 0x02, 0x00, 0x83, 0x24,
        0x3b, 0xfb, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    write_file_whole(folder / "sixteen.png", sixteen);
    try {
        read_png(folder / "sixteen.png");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("has 16 bits a channel"), std::string::npos)
            << error.what();
    }
}

TEST_F(ImageFile, TheQueueWritesEverything) {
    EncodeQueue queue(2, 2);
    for (int i = 0; i < 20; ++i) queue.push(folder / (std::to_string(i) + ".png"), gradient(true));
    queue.push(folder / "ids.png", IdImage{1, 1, {42}});
    queue.finish();
    EXPECT_EQ(file_count(), 21);
    EXPECT_EQ(read_png(folder / "19.png"), gradient(true));
}

TEST_F(ImageFile, TheQueueReportsTheFirstErrorAndDoesNotHang) {
    EncodeQueue queue(1);
    EXPECT_THROW(
        {
            for (int i = 0; i < 20; ++i)
                queue.push(folder / "missing" / "picture.png", gradient(true));
            queue.finish();
        },
        OutputError);
}

TEST_F(ImageFile, TheQueueThrowsTheErrorUntilItIsFinished) {
    EncodeQueue queue(4, 2);
    queue.push(folder / "missing" / "picture.png", gradient(true));
    const auto push_until_error = [&] {
        for (int i = 0; i < 100000; ++i) queue.push(folder / "good.png", gradient(true));
    };
    EXPECT_THROW(push_until_error(), OutputError);
    for (int i = 0; i < 3; ++i)
        EXPECT_THROW(queue.push(folder / "late.png", gradient(true)), OutputError);
    EXPECT_THROW(queue.finish(), OutputError);
    EXPECT_FALSE(fs::exists(folder / "late.png"));
    queue.push(folder / "next.png", gradient(true));
    EXPECT_NO_THROW(queue.finish());
    EXPECT_EQ(read_png(folder / "next.png"), gradient(true));
}

TEST_F(ImageFile, TheQueueIsBoundedInBytes) {
    const Image image = gradient(true);
    EncodeQueue queue(100, 1, image.rgba.size() * 3 / 2);
    // A pipe that no one reads keeps the only thread busy.
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    queue.push(pipe, image);
    std::atomic<int> pushed = 0;
    std::thread pusher([&] {
        for (int i = 0; i < 3; ++i) {
            queue.push(folder / (std::to_string(i) + ".png"), image);
            ++pushed;
        }
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(pushed, 1);
    std::ifstream reader(pipe, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(reader), {});
    pusher.join();
    queue.finish();
    EXPECT_EQ(bytes.size(), encode_png(image).size());
    EXPECT_EQ(file_count(), 4);
}

#if !defined(__SANITIZE_ADDRESS__)
/// Leaves room for the stacks of a few threads.
void limit_memory() {
    std::ifstream status("/proc/self/statm");
    rlim_t pages = 0;
    status >> pages;
    const rlim_t bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (40u << 20);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
}

TEST_F(ImageFile, TheQueueMakesDoWithFewerThreads) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto use_queue = [&] {
        limit_memory();
        EncodeQueue queue(4, 1000);
        queue.push(folder / "picture.png", gradient(true));
        queue.finish();
        std::_Exit(fs::exists(folder / "picture.png") ? 0 : 1);
    };
    EXPECT_EXIT(use_queue(), testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace scb::render
