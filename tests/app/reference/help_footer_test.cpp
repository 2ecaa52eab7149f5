#include "app/reference/help_footer.h"

#include <gtest/gtest.h>

namespace scb::app {
namespace {

using Section = FooterPart::Section;
using Lines = std::vector<std::string>;

TEST(HelpFooter, IsDividedIntoParts) {
    const std::vector<FooterPart> parts = footer_parts(
        "A sentence that\ngoes on.\n\nExit status: 0 equal; 1\ndifferent.\n\nAnother one:\n"
        "  a line\n\n  and one more\n\nExamples:\n  scb doctor\n  scb config");
    ASSERT_EQ(parts.size(), 5u);
    EXPECT_EQ(parts[0].lines, (Lines{"A sentence that", "goes on."}));
    EXPECT_EQ(parts[1].section, Section::statuses);
    EXPECT_EQ(parts[1].lines, (Lines{"0 equal; 1", "different."}));
    EXPECT_EQ(parts[2].section, Section::description);
    EXPECT_EQ(parts[2].lines, Lines{"Another one:"});
    EXPECT_TRUE(parts[3].is_literal);
    EXPECT_EQ(parts[3].lines, (Lines{"a line", "and one more"}));
    EXPECT_EQ(parts[4].section, Section::examples);
    EXPECT_EQ(parts[4].lines, (Lines{"scb doctor", "scb config"}));
}

TEST(HelpFooter, ASectionHasItsPartsAlone) {
    const std::string footer = "One.\n\nTwo.\n\nExample:\n  scb doctor";
    EXPECT_EQ(footer_parts(footer, Section::description).size(), 2u);
    EXPECT_EQ(footer_parts(footer, Section::examples).size(), 1u);
    EXPECT_TRUE(footer_parts(footer, Section::statuses).empty());
    EXPECT_TRUE(footer_parts("").empty());
}

}  // namespace
}  // namespace scb::app
