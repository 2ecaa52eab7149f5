#include "golden/suite/shell_word.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace scb::golden {
namespace {

std::string said_by_shell(const std::string& word) {
    std::FILE* pipe = ::popen(("printf %s " + word).c_str(), "r");
    std::string text;
    for (int c; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    if (pipe != nullptr) ::pclose(pipe);
    return text;
}

TEST(ShellWord, IsTakenByAShellForTheText) {
    for (const char* text : {"plain", "two words", "it's", "''", "$HOME `ls` \"x\" \\n",
                             "*?[a]~#;&|<>()!", "line\nbreak", "\xc3\xa9", "-x", "a=b", "~"})
        EXPECT_EQ(said_by_shell(shell_word(text)), text);
}

TEST(ShellWord, IsQuotedOnlyWhereItMustBe) {
    for (const char* text : {"levels", "320x240", "golden/scenes/a_b.json", "0:499:10", "1,0,-0.5",
                             "--margin=0.01", "a@b+c%d"})
        EXPECT_EQ(shell_word(text), text);
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
}

}  // namespace
}  // namespace scb::golden
