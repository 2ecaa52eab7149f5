#include "golden/suite/file_replacement.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/platform/file_bytes.h"
#include "core/platform/output_file.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> files_of(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        files[entry.path().lexically_relative(folder).string()] =
            entry.is_directory() ? "a folder" : file_bytes(entry.path().string());
    return files;
}

class FileReplacement : public testing::Test {
  protected:
    FileReplacement() {
        for (const char* name : {"a", "b", "gone"}) folder.write(name, "old");
        for (const char* name : {"a", "b", "c"}) made.write(name, "new");
    }
    std::pair<fs::path, fs::path> change(const std::string& name) const {
        return {made.path / name, folder.path / name};
    }

    const TemporaryFolder folder, made;
};

TEST_F(FileReplacement, PutsAndRemoves) {
    replace_files(folder.path, {change("a"), change("c")}, {folder.path / "gone"});
    EXPECT_EQ(files_of(folder.path),
              (std::map<std::string, std::string>{{"a", "new"}, {"b", "old"}, {"c", "new"}}));
}

// A folder cannot be replaced by a file. This stands for any error half way.
TEST_F(FileReplacement, ThatFailsHalfWayChangesNothing) {
    folder.write("a", "old");
    fs::create_directory(folder.path / "d");
    folder.write("d/inside", "kept");
    made.write("d", "new");
    const auto before = files_of(folder.path);
    try {
        replace_files(folder.path, {change("a"), change("c"), change("d"), change("b")},
                      {folder.path / "gone"});
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("d: it cannot be replaced"), std::string::npos)
            << error.what();
    }
    EXPECT_EQ(files_of(folder.path), before);
}

TEST_F(FileReplacement, ThatCannotRemoveChangesNothing) {
    const auto before = files_of(folder.path);
    try {
        replace_files(folder.path, {change("a"), change("c")},
                      {folder.path / "gone", folder.path / "not there"});
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("not there: it cannot be removed"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_EQ(files_of(folder.path), before);
}

TEST_F(FileReplacement, WithoutItsSourceChangesNothing) {
    const auto before = files_of(folder.path);
    fs::remove(made.path / "c");
    EXPECT_ANY_THROW(replace_files(folder.path, {change("a"), change("c")}, {}));
    EXPECT_EQ(files_of(folder.path), before);
}

TEST(FilesEqual, ComparesEveryByte) {
    const TemporaryFolder folder;
    // About the size of the blocks in which files are read.
    for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 200000u}) {
        std::string bytes(size, 'a');
        const std::string a = folder.write("a", bytes), b = folder.write("b", bytes);
        EXPECT_TRUE(files_equal(a, b)) << size;
        EXPECT_TRUE(files_equal(a, a)) << size;
        for (const std::size_t at : {std::size_t{0}, size / 2, size - 1}) {
            if (size == 0) continue;
            std::string other = bytes;
            other[at] = 'b';
            EXPECT_FALSE(files_equal(a, folder.write("b", other))) << size << " " << at;
        }
        EXPECT_FALSE(files_equal(a, folder.write("b", bytes + "a"))) << size;
        EXPECT_FALSE(files_equal(folder / "b", a)) << size;
    }
}

TEST(FilesEqual, IsFalseForWhatCannotBeRead) {
    const TemporaryFolder folder;
    const std::string a = folder.write("a", "a");
    EXPECT_FALSE(files_equal(a, folder / "missing"));
    EXPECT_FALSE(files_equal(folder / "missing", folder / "missing"));
    EXPECT_FALSE(files_equal(folder.path, folder.path));
}

}  // namespace

}  // namespace scb::golden
