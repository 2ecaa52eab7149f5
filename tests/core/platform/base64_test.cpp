#include "core/platform/base64.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace scb {
namespace {

std::string encoded(std::string_view text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

// The vectors of RFC 4648, section 10.
TEST(Base64, EncodesTheVectorsOfTheStandard) {
    EXPECT_EQ(encoded(""), "");
    EXPECT_EQ(encoded("f"), "Zg==");
    EXPECT_EQ(encoded("fo"), "Zm8=");
    EXPECT_EQ(encoded("foo"), "Zm9v");
    EXPECT_EQ(encoded("foob"), "Zm9vYg==");
    EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
    EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, UsesTheWholeAlphabetInOrder) {
    std::vector<std::uint8_t> bytes;
    for (unsigned i = 0; i < 64; i += 4) {
        const unsigned bits = i << 18 | (i + 1) << 12 | (i + 2) << 6 | (i + 3);
        for (int shift = 16; shift >= 0; shift -= 8)
            bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
    EXPECT_EQ(base64(bytes), "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
    EXPECT_EQ(base64(std::vector<std::uint8_t>{255}), "/w==");
}

}  // namespace
}  // namespace scb
