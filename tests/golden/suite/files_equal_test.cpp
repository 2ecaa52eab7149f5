#include "golden/suite/files_equal.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/temporary_folder.h"

namespace scb::golden {
namespace {

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
