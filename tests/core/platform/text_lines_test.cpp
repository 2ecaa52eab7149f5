#include "core/platform/text_lines.h"

#include <gtest/gtest.h>

#include "scb/error.h"
#include "tests/temporary_folder.h"

namespace scb {
namespace {

std::vector<std::string> lines_of(const std::string& bytes) {
    const TemporaryFolder folder;
    TextLines lines(folder.write("a.txt", bytes));
    std::vector<std::string> all;
    while (const auto line = lines.next()) all.emplace_back(*line);
    EXPECT_EQ(lines.number(), all.size());
    return all;
}

using Lines = std::vector<std::string>;

TEST(TextLines, AreWithoutEndsAndByteOrderMark) {
    EXPECT_EQ(lines_of(""), Lines{});
    EXPECT_EQ(lines_of("a"), Lines{"a"});
    EXPECT_EQ(lines_of("a\n"), Lines{"a"});
    EXPECT_EQ(lines_of("\n\nb"), (Lines{"", "", "b"}));
    EXPECT_EQ(lines_of("\xef\xbb\xbf"
                       "a\r\nb\r\n"),
              (Lines{"a", "b"}));
}

TEST(TextLines, PassTheEndOfTheWindow) {
    Lines expected;
    std::string text;
    for (int i = 0; i < 50'000; ++i) {
        expected.push_back(std::string(static_cast<std::size_t>(i % 97), 'x'));
        text += expected.back() + "\n";
    }
    ASSERT_GT(text.size(), std::size_t{2} << 20);
    EXPECT_EQ(lines_of(text), expected);
}

TEST(TextLines, RefuseALineThatIsTooLong) {
    const std::string longest(std::size_t{64} << 10, 'x');
    EXPECT_EQ(lines_of(longest + "\n" + longest), (Lines{longest, longest}));
    try {
        lines_of("a\n" + longest + "x\n");
        ADD_FAILURE() << "nothing was refused";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("a.txt: line 2: it has more than 64 KiB"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace scb
