#include "golden/report/junit.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/golden/compare/sample_result.h"
#include "tests/golden/report/xml_document.h"

namespace scb::golden {
namespace {

using Attributes = std::map<std::string, std::string>;

XmlElement suite_of(const SuiteResult& result) {
    const XmlElement root = parse_xml(junit_xml(result));
    EXPECT_EQ(root.name, "testsuites");
    EXPECT_EQ(root.children.size(), 1u);
    EXPECT_EQ(root.attributes, root.children[0].attributes);
    return root.children[0];
}

TEST(JUnit, CountsTheSuite) {
    EXPECT_EQ(suite_of(sample_result()).attributes, (Attributes{{"name", "golden/cases.json"},
                                                                {"tests", "8"},
                                                                {"failures", "4"},
                                                                {"errors", "2"},
                                                                {"skipped", "1"},
                                                                {"time", "2.100"}}));
    EXPECT_EQ(suite_of({}).attributes.at("tests"), "0");
}

TEST(JUnit, HasTheVersionsInTheirOrder) {
    std::vector<Attributes> properties;
    for (const XmlElement& one : suite_of(sample_result()).all("properties").at(0).all("property"))
        properties.push_back(one.attributes);
    EXPECT_EQ(properties, (std::vector<Attributes>{{{"name", "shard"}, {"value", "2/3"}},
                                                   {{"name", "scb"}, {"value", "0.1.0"}},
                                                   {{"name", "mesa"}, {"value", "22.3.6"}},
                                                   {{"name", "eigen"}, {"value", "3.4.0"}}}));
}

TEST(JUnit, SaysWhatFailedAndHowToGoOn) {
    const XmlElement one = suite_of(sample_result()).all("testcase").at(0);
    EXPECT_EQ(one.attributes, (Attributes{{"classname", "golden/cases.json"},
                                          {"name", "levels-spheres-scb"},
                                          {"time", "0.100"}}));
    ASSERT_EQ(one.children.size(), 1u);
    EXPECT_EQ(one.children[0].name, "failure");
    EXPECT_EQ(one.children[0].attributes,
              (Attributes{{"message", "Body B moved: 0.02 along x. 1 count and 19 pixels differ."},
                          {"type", "different"}}));
    EXPECT_EQ(one.children[0].text,
              "frames/100/n_v: 811 -> 812 (+1)\n"
              "gone: -9,223,372,036,854,775,808 -> none\n"
              "come: none -> 9,223,372,036,854,775,807\n"
              "text: \"a\" -> 0.5\n"
              "node 412, level 7, is missing: 19 pixels\n"
              "n_v of frame 100: 812, was 811\n"
              "reproduce: scb golden check levels-spheres-scb\n"
              "compare the traces: scb diff before.trace after.trace\n"
              "update: scb golden update levels-spheres-scb\n");
}

TEST(JUnit, TellsEveryVerdict) {
    const std::vector<XmlElement> cases = suite_of(sample_result()).all("testcase");
    ASSERT_EQ(cases.size(), 8u);
    const char* elements[] = {"failure", "", "failure", "failure", "failure", "error", "skipped"};
    const SuiteResult result = sample_result();
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_EQ(cases[i].attributes.at("name"), result.cases[i].name);
        ASSERT_EQ(cases[i].children.size(), *elements[i] ? 1u : 0u);
        if (!*elements[i]) continue;
        const XmlElement& outcome = cases[i].children[0];
        EXPECT_EQ(outcome.name, elements[i]);
        EXPECT_EQ(outcome.attributes.at("message"), first_words(result.cases[i]));
        EXPECT_EQ(outcome.attributes.at("type"), verdict_names[result.cases[i].verdict]);
    }
    EXPECT_EQ(cases[7].attributes.at("name"), "the whole run");
    EXPECT_EQ(cases[7].children.at(0).name, "error");
    EXPECT_EQ(cases[7].children[0].attributes.at("message"), "Interrupted.");
}

TEST(JUnit, EscapesWhatXmlWouldRead) {
    SuiteResult result = sample_result();
    const std::string hostile = R"(<a href='x'>&amp; "q" ]]> {{name}} {{{lines}}} <!-- τ)";
    CaseResult& one = result.cases[0];
    result.suite = one.name = one.message = hostile;
    one.cause.clear();
    result.environment = {{hostile, hostile}};
    one.counts.clear();
    one.lines = {hostile, hostile};
    one.reproduce = one.diff = one.update = "";
    const XmlElement suite = suite_of(result);
    EXPECT_EQ(suite.attributes.at("name"), hostile);
    EXPECT_EQ(suite.all("properties")[0].children.at(1).attributes,
              (Attributes{{"name", hostile}, {"value", hostile}}));
    const XmlElement parsed = suite.all("testcase").at(0);
    EXPECT_EQ(parsed.attributes.at("name"), hostile);
    EXPECT_EQ(parsed.children.at(0).attributes.at("message"), hostile);
    EXPECT_EQ(parsed.children.at(0).text, hostile + "\n" + hostile + "\n");
}

TEST(JUnit, IsWellFormedWithBytesThatXmlForbids) {
    SuiteResult result = sample_result();
    const std::string bad("\x1b[31mred\x1b[0m \xff\xef\xbf\xbe\0", 18);
    CaseResult& one = result.cases[0];
    result.suite = result.shard = one.name = one.message = one.reproduce = one.update = bad;
    result.environment = {{bad, bad}};
    one.lines = {bad};
    const std::string shown = "\ufffd[31mred\ufffd[0m \ufffd\ufffd\ufffd\ufffd\ufffd";
    EXPECT_EQ(suite_of(result).all("testcase").at(0).attributes.at("name"), shown);
}

TEST(JUnit, WritesAnyTime) {
    SuiteResult result = sample_result();
    for (const double seconds : {0.0, 1e-9, 59.9996, 1e300}) {
        result.cases[0].seconds = seconds;
        const std::string time = suite_of(result).all("testcase").at(0).attributes.at("time");
        EXPECT_NEAR(std::stod(time), seconds, 0.0005 + 1e-15 * seconds);
        EXPECT_EQ(time.find_first_not_of("0123456789."), std::string::npos) << time;
    }
}

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
