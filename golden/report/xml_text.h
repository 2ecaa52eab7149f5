#pragma once

#include <string>
#include <string_view>

namespace scb::golden {

/// The text with U+FFFD for everything that XML 1.0 does not allow: bytes that are not UTF-8,
/// control characters except tab and the line ends, U+FFFE and U+FFFF. Not escaped: '<' and '&'
/// stay.
std::string xml_text(std::string_view text);

}  // namespace scb::golden
