#pragma once

#include <string>

namespace scb::app {

/// The text in lines of at most 100 characters, unless a word is longer. All but the first begin
/// with `indent` blanks.
std::string wrapped_text(const std::string& text, std::size_t indent);

}  // namespace scb::app
