#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>
#include <string>

#include "golden/compare/pixel_box.h"
#include "golden/compare/result.h"

/// Values of the report's template.

namespace scb::golden::report {

/// Templates look up an absent key in outer scopes, so every flag is always set.
kainjow::mustache::data flag(bool value);

/// Without the sign.
std::string percent(double part, double whole);

/// Left, top, right and bottom, for the page's script; empty for an empty box.
std::string box_numbers(const PixelBox& box);

/// The case's picture and id picture, each in its versions, for the report's template. Read from
/// `folder`, the folder of results.json; a picture that is missing or not a PNG file is named in
/// its place.
kainjow::mustache::data pictures_of(const CaseResult& result, const std::filesystem::path& folder);

/// Sets the tables of a failure for the report's template: counts that differ, owners of pixels,
/// the thresholds that would have passed, and the pixels that differ most, which needs the pictures
/// in `folder`.
void set_tables(kainjow::mustache::data& values, const CaseResult& result,
                const std::filesystem::path& folder);

}  // namespace scb::golden::report
