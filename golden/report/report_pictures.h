#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>

#include "golden/compare/result.h"

namespace scb::golden::report {

/// The case's picture and id picture, each in its versions, for the report's template. Read from
/// `folder`, the folder of results.json; a picture that is missing or not a PNG file is named in
/// its place.
kainjow::mustache::data pictures_of(const CaseResult& result, const std::filesystem::path& folder);

}  // namespace scb::golden::report
