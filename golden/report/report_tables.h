#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>

#include "golden/compare/result.h"

namespace scb::golden::report {

/// Sets the tables of a failure for the report's template: counts that differ, owners of pixels,
/// the thresholds that would have passed, and the pixels that differ most, which needs the pictures
/// in `folder`.
void set_tables(kainjow::mustache::data& values, const CaseResult& result,
                const std::filesystem::path& folder);

}  // namespace scb::golden::report
