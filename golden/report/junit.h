#pragma once

#include <string>
#include <string_view>

#include "golden/compare/result.h"

namespace scb::golden {

/// The result as JUnit XML, as CI systems read it: one test case a case, with its time. A failing
/// case has a failure (an error if it could not run): its message is the sentence, its text the
/// lines, then the commands to reproduce and to update. Versions are properties of the suite. An
/// incomplete run has one more test case, an error. Characters that XML does not allow become
/// U+FFFD.
std::string junit_xml(const SuiteResult& result);

/// The text with U+FFFD for everything that XML 1.0 does not allow: bytes that are not UTF-8,
/// control characters except tab and the line ends, U+FFFE and U+FFFF. Not escaped: '<' and '&'
/// stay.
std::string xml_text(std::string_view text);

}  // namespace scb::golden
