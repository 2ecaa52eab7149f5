#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scb {

/// The number of bytes of the text's first character; 0 if it is not UTF-8 (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text);

/// The text with '?' for every byte that is not part of a character of UTF-8, for JSON.
std::string as_utf8(std::string text);

/// The text with '?' for control characters and for bytes that are not UTF-8. Names from outside
/// may contain anything; a printed text must be one line and must not control the terminal.
std::string printable(std::string text);

}  // namespace scb
