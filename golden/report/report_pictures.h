#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>

#include "golden/compare/result.h"

namespace scb::golden::report {

/// The case's picture and id picture, each in its versions, as the report's template wants them.
/// Read from `folder`, that of results.json; one that is not there or is not a PNG file is named in
/// its place.
kainjow::mustache::data pictures_of(const CaseResult& result, const std::filesystem::path& folder);

}  // namespace scb::golden::report
