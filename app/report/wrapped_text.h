#pragma once

#include <cstddef>
#include <string>

namespace scb::app {

/// Of the lines of a report, in characters.
inline constexpr std::size_t report_width = 100;

/// The text in lines of at most report_width characters, unless a word is longer. All but the first
/// begin with `indent` blanks.
std::string wrapped_text(const std::string& text, std::size_t indent);

}  // namespace scb::app
