#pragma once

#include <string>

namespace scb {

/// The text with '?' for every byte that is not part of a character of UTF-8, as JSON wants it.
std::string as_utf8(std::string text);

}  // namespace scb
