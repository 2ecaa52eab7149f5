#include "core/platform/utf8.h"

#include <algorithm>

namespace scb {

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned lead = byte(0), second = byte(1);
    if (lead < 0x80) return 1;
    if (lead < 0xc2 || lead > 0xf4) return 0;
    // No second spelling of a shorter character, no surrogates, nothing beyond U+10FFFF.
    const unsigned low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (second < low || second > high) return 0;
    const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    for (std::size_t i = 2; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    return length;
}

std::string as_utf8(std::string text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(std::string_view(text).substr(at));
        if (length == 0) text[at] = '?';
        at += std::max<std::size_t>(1, length);
    }
    return text;
}

std::string printable(std::string text) {
    text = as_utf8(std::move(text));
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    // Two bytes: C2 80 to C2 9F, which terminals also obey. Three bytes: characters that change the
    // direction of the following text.
    const auto is = [&text](std::size_t i, unsigned char lowest, unsigned char highest) {
        const auto byte = static_cast<unsigned char>(text[i]);
        return byte >= lowest && byte <= highest;
    };
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (is(i, 0xc2, 0xc2) && is(i + 1, 0x80, 0x9f)) text.replace(i, 2, "?");
        if (i + 2 < text.size() && is(i, 0xe2, 0xe2) &&
            ((is(i + 1, 0x80, 0x80) && (is(i + 2, 0xaa, 0xae) || is(i + 2, 0x8e, 0x8f))) ||
             (is(i + 1, 0x81, 0x81) && is(i + 2, 0xa6, 0xa9))))
            text.replace(i, 3, "?");
    }
    return text;
}

}  // namespace scb
