#pragma once

#include <string>

namespace scb::app {

/// Refuses what is not a whole number in decimal: CLI11 alone reads 010 as 8, and holds a number
/// that is too large for the largest one.
std::string decimal_number(const std::string& text);
/// The same for numbers with a fraction.
std::string real_number(const std::string& text);

}  // namespace scb::app
