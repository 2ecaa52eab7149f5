#include "core/platform/file_bytes.h"

#include <gtest/gtest.h>

#include "core/platform/file_window.h"
#include "tests/open_file_limit.h"
#include "tests/temporary_folder.h"

namespace scb {
namespace {

TEST(FileBytes, OfAFileThatCannotBeOpenedSayWhy) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.jsonl", "{\"end\": true}"),
                      expected = file +
                                 ": cannot be opened (Too many open files); raise the limit of "
                                 "open files (ulimit -n).";
    EXPECT_EQ(refusal_without_files([&] { file_bytes(file); }), expected);
    EXPECT_EQ(refusal_without_files([&] { FileWindow{file}; }), expected);
}

}  // namespace
}  // namespace scb
