#pragma once

#include <cstdint>
#include <string>

namespace scb {

/// What printf would print, as a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// For "%llu" of format: on some systems std::uint64_t is an `unsigned long`.
constexpr unsigned long long wide(std::uint64_t value) { return value; }

/// The text behind as many blanks as it takes to that width; a character of UTF-8 counts once.
std::string right_aligned(const std::string& text, std::size_t width);

/// The shortest decimal text that reads back as the same double; "inf" and "nan" for those.
std::string exact_number(double value);

}  // namespace scb
