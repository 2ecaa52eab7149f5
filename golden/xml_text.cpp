#include "golden/xml_text.h"

#include <algorithm>
#include <cstddef>

namespace scb {
namespace {

/// How many bytes of the text's start are one character that XML allows (section 2.2 of the
/// recommendation) in UTF-8 (Unicode 15, table 3-7); 0 where they are none.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned lead = byte(0), second = byte(1);
    if (lead < 0x20) return lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
    if (lead < 0x80) return 1;
    if (lead < 0xc2 || lead > 0xf4) return 0;
    // No second spelling of a shorter character, no surrogates, nothing beyond U+10FFFF.
    const unsigned low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (second < low || second > high) return 0;
    const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    for (std::size_t i = 2; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool is_noncharacter = lead == 0xef && second == 0xbf && byte(2) >= 0xbe;
    return is_noncharacter ? 0 : length;
}

}  // namespace

std::string xml_text(std::string_view text) {
    std::string allowed;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_length(text.substr(at));
        if (length == 0)
            allowed += "\uFFFD";
        else
            allowed += text.substr(at, length);
        at += std::max<std::size_t>(1, length);
    }
    return allowed;
}

}  // namespace scb
