#include "core/platform/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "core/platform/file_bytes.h"

namespace scb {
namespace {

namespace fs = std::filesystem;

class OutputFile : public testing::Test {
  protected:
    OutputFile() {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = fs::temp_directory_path() / ("scb_output_file_" + name);
        fs::remove_all(folder);
        fs::create_directory(folder);
    }
    ~OutputFile() override { fs::remove_all(folder); }

    std::ptrdiff_t file_count() const { return std::distance(fs::directory_iterator(folder), {}); }

    fs::path folder;
};

TEST_F(OutputFile, AFileIsReplacedWhole) {
    const std::vector<std::uint8_t> first(1000, 1), second(10, 2);
    write_file_whole(folder / "file", first);
    write_file_whole(folder / "file", second);
    EXPECT_EQ(fs::file_size(folder / "file"), 10u);
    EXPECT_EQ(file_count(), 1);
}

TEST_F(OutputFile, AFailureNamesTheFileAndLeavesNothingBehind) {
    const std::vector<std::uint8_t> bytes(100, 1);
    std::ofstream(folder / "file") << "kept";
    fs::create_directory(folder / "folder");
    std::ofstream(folder / "folder" / "inside") << "kept";
    for (const fs::path& path :
         {folder / "missing" / "picture.png", folder / "file" / "picture.png", folder / "folder"}) {
        try {
            write_file_whole(path, bytes);
            ADD_FAILURE() << path;
        } catch (const OutputError& error) {
            EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos)
                << error.what();
        }
    }
    EXPECT_EQ(file_count(), 2);
    EXPECT_EQ(fs::file_size(folder / "file"), 4u);
}

TEST_F(OutputFile, AFullDiskIsReported) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    try {
        write_file_whole("/dev/full", std::vector<std::uint8_t>(100, 1));
        ADD_FAILURE();
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("make room"), std::string::npos) << error.what();
    }
    EXPECT_TRUE(fs::exists("/dev/full"));
}

TEST_F(OutputFile, AFileHasThePermissionsOfTheOneBeforeOrOfAnyNewFile) {
    const mode_t before = ::umask(027);
    write_file_whole(folder / "file", std::vector<std::uint8_t>(10, 1));
    ::umask(before);
    EXPECT_EQ(fs::status(folder / "file").permissions(), fs::perms{0640});
    fs::permissions(folder / "file", fs::perms{0600});
    write_file_whole(folder / "file", "other");
    EXPECT_EQ(fs::status(folder / "file").permissions(), fs::perms{0600});
}

TEST_F(OutputFile, ALinkStaysAndWhatItLeadsToIsReplaced) {
    std::ofstream(folder / "file") << "replaced";
    fs::create_symlink("file", folder / "link");
    write_file_whole(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(fs::file_size(folder / "file"), 3u);
    EXPECT_EQ(file_count(), 2);
}

TEST_F(OutputFile, NamesMayBeAsLongAsNamesCan) {
    write_file_whole(folder / std::string(250, 'x'), "text");
    EXPECT_EQ(file_count(), 1);
}

// While a file is written it has no name, so that nothing can leave a part of it behind.
TEST_F(OutputFile, AnUnfinishedFileHasNoName) {
    const int probe = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (probe < 0) GTEST_SKIP() << "this file system has no files without a name";
    ::close(probe);
    const auto interrupted = [&] {
        const rlimit most = {4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &most);  // the signal comes in the middle of the write
        std::signal(SIGXFSZ, SIG_DFL);
        write_file_whole(folder / "file", std::vector<std::uint8_t>(10000, 1));
    };
    EXPECT_EXIT(interrupted(), testing::KilledBySignal(SIGXFSZ), "");
    EXPECT_EQ(file_count(), 0);
}

TEST_F(OutputFile, IsWrittenInPartsAndNamedAtTheEnd) {
    write_file_whole(folder / "file", "old");
    {
        WholeFile unfinished(folder / "file");
        unfinished.append("part");
    }
    EXPECT_EQ(fs::file_size(folder / "file"), 3u);
    EXPECT_EQ(file_count(), 1);
    WholeFile file(folder / "file");
    file.append("two ");
    file.append("parts");
    EXPECT_EQ(fs::file_size(folder / "file"), 3u);
    file.finish();
    EXPECT_EQ(file_bytes(folder / "file"), "two parts");
    EXPECT_EQ(file_count(), 1);
}

TEST_F(OutputFile, NoOtherFileIsTouched) {
    const fs::path other = folder / ("file.part-" + std::to_string(::getpid()));
    std::ofstream(other) << "kept";
    write_file_whole(folder / "file", std::vector<std::uint8_t>(10, 1));
    EXPECT_EQ(file_count(), 2);
    EXPECT_EQ(fs::file_size(other), 4u);
}

TEST_F(OutputFile, ThreadsMayWriteOnePath) {
    const auto write = [&](std::uint8_t value) {
        const std::vector<std::uint8_t> bytes(100000, value);
        for (int i = 0; i < 100; ++i) EXPECT_NO_THROW(write_file_whole(folder / "file", bytes));
    };
    std::thread other(write, 1);
    write(2);
    other.join();
    std::ifstream file(folder / "file", std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    ASSERT_EQ(bytes.size(), 100000u);
    EXPECT_EQ(bytes.find_first_not_of(bytes[0]), std::string::npos);
    EXPECT_EQ(file_count(), 1);
}

}  // namespace
}  // namespace scb
