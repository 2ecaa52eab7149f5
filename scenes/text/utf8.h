#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scb::scenes {

/// How many bytes of the text's start are one character of UTF-8; 0 where they are none (Unicode
/// 15, table 3-7).
std::size_t utf8_length(std::string_view text);

/// The text with '?' for every byte that is not part of a character of UTF-8, as JSON wants it.
std::string as_utf8(std::string text);

/// The text with '?' for control characters and for what is no UTF-8: names from outside may hold
/// anything, and what is printed is one line and does not steer the terminal.
std::string printable(std::string text);

}  // namespace scb::scenes
