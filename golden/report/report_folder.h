#pragma once

#include <filesystem>

#include "golden/compare/result.h"

namespace scb::golden {

/// Writes report.html and results.json into the folder, and beside them the pictures and traces in
/// `work`. The files of an earlier report, as listed in its results.json, are removed first, so
/// that none of its pictures seems to belong to this report; other files stay. Throws OutputError.
void write_report_folder(const SuiteResult& result, const std::filesystem::path& folder,
                         const std::filesystem::path& work);

/// The result as the text of results.json.
std::string results_json(const SuiteResult& result);

}  // namespace scb::golden
