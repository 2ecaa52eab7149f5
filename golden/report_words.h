#pragma once

#include <cstdint>
#include <kainjow/mustache.hpp>
#include <string>

#include "golden/pixel_box.h"

/// How the report says things; also its templates' values.
namespace scb::report {

/// In templates a key that is absent is looked up further out, so every flag is always set.
kainjow::mustache::data flag(bool value);

/// "20,480"
std::string grouped(std::uint64_t n);

/// "−20,480"
std::string grouped_signed(std::int64_t n);

/// "+12", "−3"; of any two numbers, for unsigned differences do not overflow.
std::string change_of(std::int64_t before, std::int64_t after);

/// "1 case", "20 cases"
std::string counted(std::uint64_t n, const char* one, const char* many);

/// Without the sign.
std::string percent(double part, double whole);

/// Left, top, right and bottom, for the page's script; empty for an empty box.
std::string box_numbers(const PixelBox& box);

/// For people: "at (x, y)", or "from (x, y) to (x, y)"; empty for an empty box.
std::string box_words(const PixelBox& box);

}  // namespace scb::report
