#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "golden/compare/result.h"

namespace scb::golden {

/// Text from a file, made safe for a line of a terminal or of a log of CI: control characters and
/// characters that change the direction of writing become "\n", "\x1b", "\u202e"; bytes that are
/// not UTF-8 become '?'. Neither form of a command of GitHub Actions, "::" in front or "##["
/// anywhere, is left.
std::string plain_text(std::string_view text);

/// The first counts that differ, with their values, a line each: "frames/100/n_v: 20,627 -> 20,630
/// (+3)"; then a line with the number of further counts.
std::vector<std::string> count_lines(const CaseResult& result, std::size_t most = 10);

/// The lines below the message of a case, for terminals and logs of CI: the first counts that
/// differ, then its lines. All as plain_text.
std::vector<std::string> result_lines(const CaseResult& result);

}  // namespace scb::golden
