#include "golden/report/xml_text.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/golden/report/xml_document.h"

namespace scb::golden {
namespace {

TEST(XmlText, KeepsWhatXmlAllows) {
    for (const char* text : {"", "plain", "tab\tline\nreturn\r", "τ ≤ ½", "\u007f", "\xed\x9f\xbf",
                             "\xee\x80\x80", "\ufffd", "\U00010000", "\U0010ffff", "<&>"})
        EXPECT_EQ(xml_text(text), text);
}

TEST(XmlText, ReplacesWhatXmlForbids) {
    EXPECT_EQ(xml_text(std::string_view("a\0b", 3)), "a\ufffdb");
    EXPECT_EQ(xml_text("\x01\x1f\x1b[1m"), "\ufffd\ufffd\ufffd[1m");
    EXPECT_EQ(xml_text("\ufffe\uffff"), "\ufffd\ufffd\ufffd\ufffd\ufffd\ufffd");
    EXPECT_EQ(xml_text("\xff\xc3"), "\ufffd\ufffd");
    EXPECT_EQ(xml_text("\xc0\x80 \xed\xa0\x80 \xf4\x90\x80\x80").find_first_of("\xc0\xed\xf4"),
              std::string::npos);
}

TEST(XmlText, IsWellFormedWhateverTheBytes) {
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        std::string bytes;
        for (std::size_t n = random() % 60; n > 0; --n)
            bytes += random() % 2 ? "\xef\xbf\xbe\xed\xa0\xf0\x90\x80\xc2\x0b"[random() % 10]
                                  : static_cast<char>(random());
        std::string text = xml_text(bytes);
        for (char& c : text)
            if (c == '<' || c == '&' || c == '>') c = ' ';
        EXPECT_NO_THROW(parse_xml("<a>" + text + "</a>")) << testing::PrintToString(bytes);
    }
}

}  // namespace
}  // namespace scb::golden
