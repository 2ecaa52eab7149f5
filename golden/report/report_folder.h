#pragma once

#include <filesystem>

#include "golden/compare/result.h"

namespace scb::golden {

/// Writes report.html and results.json into the folder, and beside them the pictures and traces
/// that are in `work`. What an earlier report has left there, by its results.json, is removed
/// first, so that no picture of it is taken for one of this; other files stay. Throws OutputError.
void write_report_folder(const SuiteResult& result, const std::filesystem::path& folder,
                         const std::filesystem::path& work);

/// The result as the text of results.json.
std::string results_json(const SuiteResult& result);

}  // namespace scb::golden
