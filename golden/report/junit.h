#pragma once

#include <string>

#include "golden/compare/result.h"

namespace scb::golden {

/// The result as JUnit XML, as CI systems read it: one test case a case, with its time. Where a
/// case fails it has a failure (an error where it could not run) with the sentence as its message
/// and as its text the lines, then the commands to reproduce and to update. Versions are properties
/// of the suite. An incomplete run has one more test case, an error. Characters that XML does not
/// allow become U+FFFD.
std::string junit_xml(const SuiteResult& result);

}  // namespace scb::golden
