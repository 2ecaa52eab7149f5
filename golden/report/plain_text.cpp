#include "golden/report/plain_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/text_format.h"
#include "core/platform/utf8.h"
#include "golden/compare/number_words.h"

namespace scb::golden {
namespace {

/// The code point of a character of UTF-8.
unsigned code_point(std::string_view character) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
    if (character.size() == 1) return byte(0);
    unsigned code = byte(0) & (0xffu >> (character.size() + 1));
    for (std::size_t i = 1; i < character.size(); ++i) code = code << 6 | (byte(i) & 0x3fu);
    return code;
}

/// Control characters (Unicode 15, section 23.1), line and paragraph separators, and characters
/// that embed or override a direction (section 23.2).
bool is_control(unsigned code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069);
}

std::string escaped(unsigned code) {
    if (code == '\n') return "\\n";
    if (code == '\r') return "\\r";
    if (code == '\t') return "\\t";
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), code < 0x100 ? "\\x%02x" : "\\u%04x", code);
    return text.data();
}

}  // namespace

std::string plain_text(std::string_view text) {
    std::string plain;
    // A command may have any blanks in front, also Unicode blanks.
    bool in_front = true;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text.substr(at));
        const std::string_view character = text.substr(at, std::max<std::size_t>(1, length));
        const unsigned code = length == 0 ? '?' : code_point(character);
        const std::string_view rest = text.substr(at);
        if (length == 0)
            plain += '?';
        else if (is_control(code))
            plain += escaped(code);
        else if ((in_front && rest.starts_with("::")) || rest.starts_with("##["))
            plain += escaped(code);
        else
            plain += character;
        in_front &= code == ' ' || code >= 0x80;
        at += character.size();
    }
    return plain;
}

namespace {

// Many log viewers show only ASCII.
constexpr const char* minus = "-";

std::string value_of(const std::optional<std::int64_t>& count, const std::string& text) {
    return count ? words::grouped_signed(*count, minus) : text.empty() ? "none" : text;
}

std::string line_of(const CountChange& change) {
    if (is_hash(change) && change.before && change.after) return change.place + ": changed";
    std::string line = change.place + ": " + value_of(change.before, change.before_text) + " -> " +
                       value_of(change.after, change.after_text);
    if (change.before && change.after)
        line += " (" + words::change_of(*change.before, *change.after, minus) + ")";
    return line;
}

}  // namespace

std::vector<std::string> count_lines(const CaseResult& result, std::size_t most) {
    std::vector<std::string> lines;
    std::size_t more = 0;
    for (const CountChange& change : result.counts) {
        if (is_of_trace(change)) continue;
        if (lines.size() < most)
            lines.push_back(plain_text(line_of(change)));
        else
            ++more;
    }
    if (more > 0) lines.push_back("and " + counted(more, "more count", "more counts"));
    return lines;
}

std::vector<std::string> result_lines(const CaseResult& result) {
    std::vector<std::string> lines = count_lines(result);
    for (const std::string& line : result.lines) lines.push_back(plain_text(line));
    return lines;
}

}  // namespace scb::golden
