#pragma once

#include <kainjow/mustache.hpp>
#include <string>

#include "golden/compare/pixel_box.h"

/// Values of the report's template.
namespace scb::golden::report {

/// Templates look up an absent key in outer scopes, so every flag is always set.
kainjow::mustache::data flag(bool value);

/// Without the sign.
std::string percent(double part, double whole);

/// Left, top, right and bottom, for the page's script; empty for an empty box.
std::string box_numbers(const PixelBox& box);

}  // namespace scb::golden::report
