#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scb {

/// How many bytes of the text's start are one character of UTF-8; 0 where they are none (Unicode
/// 15, table 3-7).
std::size_t utf8_length(std::string_view text);

/// The text with '?' for every byte that is not part of a character of UTF-8, as JSON wants it.
std::string as_utf8(std::string text);

}  // namespace scb
