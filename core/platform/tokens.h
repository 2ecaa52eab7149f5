#pragma once

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/text_format.h"

namespace scb {

/// The words of a text, one after the other, separated by blanks and line ends.
struct Words {
    std::string_view rest;

    /// The next word; empty at the end.
    std::string_view next() {
        std::size_t start = 0;
        while (start < rest.size() && is_blank(rest[start])) ++start;
        std::size_t end = start;
        while (end < rest.size() && !is_blank(rest[end])) ++end;
        const std::string_view word = rest.substr(start, end - start);
        rest.remove_prefix(end);
        return word;
    }

    static bool is_blank(char c) {
        return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
    }
};

/// The number that a whole word spells ("nan" and "inf" included), if any.
inline std::optional<double> number_in(std::string_view word) {
    if (!word.empty() && word[0] == '+') word.remove_prefix(1);
    double value = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = !word.empty() && parsed.ptr == word.data() + word.size();
    if (!whole || parsed.ec == std::errc::invalid_argument) return std::nullopt;
    // A number too large or too small for a double is still spelled correctly: infinite, or 0.
    if (parsed.ec == std::errc::result_out_of_range) {
        const CLocale with_points;
        return std::strtod(std::string(word).c_str(), nullptr);
    }
    return value;
}

/// At most 40 characters of a text from outside, safe for a message.
inline std::string excerpt(std::string_view text) {
    std::string plain(text.substr(0, 40));
    for (char& c : plain)
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
    return plain;
}

}  // namespace scb
