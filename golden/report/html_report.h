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

/// Writes report.html and results.json into the folder, and beside them the pictures and traces in
/// `work`. The files of an earlier report, as listed in its results.json, are removed first, so
/// that none of its pictures seems to belong to this report; other files stay. Throws OutputError.
void write_report_folder(const SuiteResult& result, const std::filesystem::path& folder,
                         const std::filesystem::path& work);

/// The result as the text of results.json.
std::string results_json(const SuiteResult& result);

}  // namespace scb::golden
