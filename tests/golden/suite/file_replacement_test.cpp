#include "golden/suite/file_replacement.h"

#include <gtest/gtest.h>

#include <map>

#include "render/files/output_file.h"
#include "scenes/text/file_bytes.h"
#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> files_of(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        files[entry.path().lexically_relative(folder).string()] =
            entry.is_directory() ? "a folder" : scenes::file_bytes(entry.path().string());
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
    } catch (const render::OutputError& error) {
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
    } catch (const render::OutputError& error) {
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

}  // namespace
}  // namespace scb::golden
