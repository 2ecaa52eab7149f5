#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>

#include "golden/compare/result.h"

namespace scb::golden::report {

/// Sets the tables of a failure, as the report's template wants them: counts that differ, owners of
/// pixels, the thresholds that would have passed, and the pixels that differ most, for which the
/// pictures are read from `folder`.
void set_tables(kainjow::mustache::data& values, const CaseResult& result,
                const std::filesystem::path& folder);

}  // namespace scb::golden::report
