#pragma once

#include <string>
#include <string_view>

namespace scb::golden {

/// Text from a file, made safe for a line of a terminal or of a log of CI: control characters and
/// characters that change the direction of writing become "\n", "\x1b", "\u202e"; bytes that are
/// not UTF-8 become '?'. Neither form of a command of GitHub Actions, "::" in front or "##["
/// anywhere, is left.
std::string plain_text(std::string_view text);

}  // namespace scb::golden
