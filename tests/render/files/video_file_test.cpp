#include "render/files/video_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/platform/output_file.h"
#include "tests/core/platform/children.h"
#include "tests/temporary_folder.h"

namespace scb::render {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

constexpr int frame_width = 320, frame_height = 240;

Image picture(int i) {
    Image image{frame_width, frame_height,
                std::vector<std::uint8_t>(4 * frame_width * frame_height, 255)};
    for (std::size_t at = 0; at < image.rgba.size(); at += 4)
        image.rgba[at] = static_cast<std::uint8_t>(8 * i);
    return image;
}

/// A program of the name ffmpeg, first on PATH while this exists.
struct FakeProgram {
    explicit FakeProgram(const std::string& script) : path_before(std::getenv("PATH")) {
        const std::string file = folder.write("ffmpeg", "#!/bin/sh\n" + script + "\n");
        ::chmod(file.c_str(), 0755);
        ::setenv("PATH", (folder.path.string() + ":" + path_before).c_str(), 1);
    }
    ~FakeProgram() { ::setenv("PATH", path_before.c_str(), 1); }

    TemporaryFolder folder;
    std::string path_before;
};

struct VideoFileTest : testing::Test {
    TemporaryFolder folder;
    std::string path = folder / "v.mp4";

    /// What the video fails with, after 40 frames at most.
    std::string failure(seconds patience) {
        std::string sentence;
        try {
            VideoFile video(path, frame_width, frame_height, 25, {}, patience);
            for (int i = 0; i < 40; ++i) video.push(picture(i));
            video.finish();
        } catch (const OutputError& error) {
            sentence = error.what();
        }
        EXPECT_TRUE(no_child_is_left());
        EXPECT_TRUE(std::filesystem::is_empty(folder.path));
        return sentence;
    }
    std::string text() const {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

TEST_F(VideoFileTest, IsTheSameBytesTwice) {
    if (!is_on_path(video_program)) GTEST_SKIP() << "the package ffmpeg is not installed";
    std::string first;
    for (int run = 0; run < 2; ++run) {
        VideoFile video(path, frame_width, frame_height, 25, {});
        for (int i = 0; i < 30; ++i) video.push(picture(i));
        video.finish();
        EXPECT_EQ(video.frames(), 30u);
        if (run == 0) first = text();
    }
    EXPECT_EQ(text(), first);
    EXPECT_EQ(first.substr(4, 4), "ftyp");
    EXPECT_LT(first.find("moov"), first.find("mdat"));  // players need not load all of it first
    EXPECT_TRUE(no_child_is_left());
}

TEST_F(VideoFileTest, IsNotWrittenUnlessFinished) {
    for (const char* script : {"exec sleep 600", "sleep 600", "cat >/dev/null"}) {
        const FakeProgram fake(script);
        const Clock::time_point start = Clock::now();
        {
            VideoFile video(path, frame_width, frame_height, 25, {});
            for (int i = 0; i < 3; ++i) video.push(picture(i));
        }
        EXPECT_LT(Clock::now() - start, seconds(20)) << script;
        EXPECT_TRUE(no_child_is_left()) << script;
        EXPECT_TRUE(std::filesystem::is_empty(folder.path)) << script;
    }
}

TEST_F(VideoFileTest, FailsAsTheProgramDoes) {
    const auto failure_of = [&](const std::string& script) {
        const FakeProgram fake(script);
        return failure(seconds(60));
    };
    const std::string start = "Cannot write \"" + path + "\": ffmpeg ";
    EXPECT_EQ(failure_of("echo first; echo 'No such encoder' >&2; echo; exit 1").find(start), 0u);
    EXPECT_NE(failure_of("echo first; echo 'No such encoder' >&2; echo; exit 1")
                  .find("ffmpeg failed and said \"No such encoder\"; see that"),
              std::string::npos);
    // It has taken everything when it fails.
    EXPECT_NE(failure_of("cat >/dev/null; echo full; exit 1").find("failed and said \"full\""),
              std::string::npos);
    EXPECT_NE(failure_of("cat >/dev/null; echo half > /proc/self/fd/3; exit 1").find("failed"),
              std::string::npos);
    // As ffmpeg does where the disk is full.
    EXPECT_NE(failure_of("cat >/dev/null; echo full; exit 228").find("failed and said \"full\""),
              std::string::npos);
    EXPECT_NE(failure_of("exit 0").find("ended without a whole video"), std::string::npos);
    EXPECT_NE(failure_of("cat >/dev/null").find("ended without a whole video"), std::string::npos);
    // It says so and exits with 0, with the start of a video written.
    EXPECT_NE(failure_of("cat >/dev/null; echo half > /proc/self/fd/3; printf 'no\\0room'")
                  .find("ended without a whole video and said \"no"),
              std::string::npos);
    EXPECT_NE(failure_of("kill -9 $$").find("ended by signal 9"), std::string::npos);
    EXPECT_NE(failure_of("exec 0<&-; sleep 600").find("did not go on"), std::string::npos);
}

TEST_F(VideoFileTest, DoesNotWaitForAProgramThatTakesNothing) {
    const FakeProgram fake("sleep 600");
    const Clock::time_point start = Clock::now();
    EXPECT_NE(failure(seconds(1)).find("did not go on"), std::string::npos);
    EXPECT_LT(Clock::now() - start, seconds(30));
}

TEST_F(VideoFileTest, InheritsNothingAndHasAProcessGroupOfItsOwn) {
    constexpr int mine = 200;
    ASSERT_EQ(::dup2(STDERR_FILENO, mine), mine);
    const FakeProgram fake(
        "cat >/dev/null; test -e /proc/$$/fd/200 && echo has 200 && exit 1;"
        "test -e /proc/$$/fd/3 || { echo has no 3; exit 1; };"
        "echo group $(cut -d ' ' -f 5 /proc/$$/stat) of $$; exit 1");
    const std::string said = failure(seconds(60));
    ::close(mine);
    const std::size_t at = said.find("group "), of = said.find(" of ");
    ASSERT_NE(at, std::string::npos) << said;
    EXPECT_EQ(said.substr(at + 6, of - at - 6), said.substr(of + 4, said.find('"', of) - of - 4))
        << said;
}

TEST_F(VideoFileTest, IsNotStartedWhereThereIsNoProgram) {
    const std::string before = std::getenv("PATH");
    ::setenv("PATH", folder.path.c_str(), 1);
    EXPECT_FALSE(is_on_path(video_program));
    const std::string sentence = failure(seconds(60));
    ::setenv("PATH", before.c_str(), 1);
    EXPECT_NE(sentence.find("Cannot start ffmpeg: No such file"), std::string::npos) << sentence;
    EXPECT_TRUE(is_on_path("sh"));
}

}  // namespace
}  // namespace scb::render
