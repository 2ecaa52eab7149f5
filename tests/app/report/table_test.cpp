#include "app/report/table.h"

#include <gtest/gtest.h>

namespace scb::app {
namespace {

/// A level with all values, and one whose last cells are left out.
Table levels() {
    Table table({{"level", "level", 5},
                 {"time", "ms", 8},
                 {"ratio", "ratio", 7, Align::right, 0, false},
                 {"", "exact"},
                 {"shown", "", 6},
                 {"rule", "rule", 9, Align::left, 2}});
    table.add({0, {0.1, "%.3f"}, {}, true, {2.5, "%.1f"}, "cost, \"least\""}, "  stopped");
    table.add({1, {0.25, "%.3f"}, {0.5, "%.1f"}, false});
    return table;
}

TEST(Table, OfTextHasAlignedColumnsAndNotes) {
    EXPECT_EQ(levels().text(),
              "level    time  ratio shown  rule\n"
              "    0   0.100          2.5  cost, \"least\"  stopped\n"
              "    1   0.250    0.5\n");
}

TEST(Table, OfCsvHasKeysAndQuotedTexts) {
    EXPECT_EQ(levels().csv_header(), "level,ms,exact,rule\n");
    EXPECT_EQ(levels().csv_rows("a,"),
              "a,0,0.10000000000000001,1,\"cost, \"\"least\"\"\"\n"
              "a,1,0.25,0,\n");
}

TEST(Table, OfJsonLeavesOutCellsWithoutValues) {
    EXPECT_EQ(levels().json().dump(),
              "[{\"level\":0,\"ms\":0.1,\"exact\":true,\"rule\":\"cost, \\\"least\\\"\"},"
              "{\"level\":1,\"ms\":0.25,\"ratio\":0.5,\"exact\":false}]");
}

TEST(Table, OfHtmlIsEscaped) {
    Table table({{"a < b", "", 0, Align::left}, {"time"}});
    table.add({"R&D", 5}, "late");
    EXPECT_EQ(table.html(),
              "<table>\n<tr><th>a &lt; b</th><th class=\"number\">time</th></tr>\n"
              "<tr><td>R&amp;D</td><td class=\"number\">5</td><td>late</td></tr>\n</table>\n");
}

TEST(Table, IsMadeOfFields) {
    const std::vector<Field<int>> fields = {{{"n", "n", 3}, [](auto& n) { return n; }},
                                            {{"square", "n2", 8}, [](auto& n) { return n * n; }}};
    EXPECT_EQ(table_of<int>(fields).text(), "  n  square\n");
    EXPECT_EQ(table_of<int>(fields, {3}).text(), "  n  square\n  3       9\n");
}

}  // namespace
}  // namespace scb::app
