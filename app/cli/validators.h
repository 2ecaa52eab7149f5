#pragma once

#include <string>

namespace scb::app {

/// Refuses all but whole decimal numbers: CLI11 reads 010 as 8, and replaces a number that is too
/// large by the largest one.
std::string decimal_number(const std::string& text);
/// The same for numbers with a fraction.
std::string real_number(const std::string& text);

}  // namespace scb::app
