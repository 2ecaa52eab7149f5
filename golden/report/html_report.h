#pragma once

#include <filesystem>
#include <string>

#include "golden/compare/result.h"

namespace scb::golden {

/// The report of a run for people: one HTML file with its pictures, styles and script inside, which
/// opens from disk and loads nothing. Failures first, by verdict, then in the order of the suite.
/// The pictures are read from `folder`, the folder of results.json; a picture that is missing or
/// not a PNG file is named in its place. Id pictures are shown with a color for each thing. All
/// text of `result` is escaped.
std::string report_html(const SuiteResult& result, const std::filesystem::path& folder);

}  // namespace scb::golden
