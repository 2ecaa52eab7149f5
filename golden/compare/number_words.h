#pragma once

#include <cstdint>
#include <string>

#include "golden/compare/pixel_box.h"

/// Words for numbers and places in messages, lines and pages.
namespace scb::golden::words {

/// "−20,480"; `minus` is U+2212 by default.
std::string grouped_signed(std::int64_t n, const char* minus = "−");

/// "+12", "−3"; for any two numbers, since unsigned differences do not overflow.
std::string change_of(std::int64_t before, std::int64_t after, const char* minus = "−");

/// "at (x, y)" for one pixel, else "from (x, y) to (x, y)", both within; empty for an empty box.
std::string box_words(const PixelBox& box);

}  // namespace scb::golden::words
