#include "core/platform/number_list.h"

#include <gtest/gtest.h>

namespace scb {
namespace {

TEST(NumberList, IsReadAsItIsWritten) {
    const struct {
        std::vector<int> numbers;
        const char* text;
    } cases[] = {{{7}, "7"},
                 {{1, 2, 3}, "1,2,3"},
                 {{0, 1, 2, 3}, "0:3"},
                 {{0, 10, 20, 30}, "0:30:10"},
                 {{0, 10, 20, 31}, "0,10,20,31"},
                 {{0, 9, 20, 30}, "0,9,20,30"}};
    for (const auto& [numbers, text] : cases) {
        EXPECT_EQ(list_text(numbers), text);
        EXPECT_EQ(parse_frames(text, 100, "cone"), numbers);
    }
}

}  // namespace
}  // namespace scb
