#include "golden/report/plain_text.h"

#include <gtest/gtest.h>

namespace scb::golden {
namespace {

TEST(PlainText, IsOneLineThatMovesNoCursor) {
    EXPECT_EQ(plain_text("n_v: 1 -> 2 (\xc3\xa4, \xe2\x82\xac)"),
              "n_v: 1 -> 2 (\xc3\xa4, \xe2\x82\xac)");
    EXPECT_EQ(plain_text("a\nb\r\tc"), "a\\nb\\r\\tc");
    EXPECT_EQ(plain_text("\x1b[31mred\x7f\a"), "\\x1b[31mred\\x7f\\x07");
    EXPECT_EQ(plain_text("\xc2\x9b"
                         "31m"),
              "\\x9b"
              "31m");
    EXPECT_EQ(plain_text(std::string("zero\0", 5)), "zero\\x00");
    EXPECT_EQ(plain_text("\xe2\x80\xae"
                         "abc\xe2\x80\xa8"),
              "\\u202e"
              "abc\\u2028");
    EXPECT_EQ(plain_text("half \xe2\x82"), "half ??");
    EXPECT_EQ(plain_text("\xf0\x9f\x98\x80"), "\xf0\x9f\x98\x80");
    EXPECT_EQ(plain_text(""), "");
}

TEST(PlainText, IsNoCommandOfGithubActions) {
    EXPECT_EQ(plain_text("::add-mask::1"), "\\x3a:add-mask::1");
    EXPECT_EQ(plain_text("  ::stop-commands::x"), "  \\x3a:stop-commands::x");
    EXPECT_EQ(plain_text("\xc2\xa0::error::x"), "\xc2\xa0\\x3a:error::x");
    EXPECT_EQ(plain_text("a ##[error]x"), "a \\x23#[error]x");
    EXPECT_EQ(plain_text("a::b"), "a::b");
}

}  // namespace
}  // namespace scb::golden
