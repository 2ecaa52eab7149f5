#include "golden/report/xml_text.h"

#include <algorithm>
#include <cstddef>

#include "scenes/text/utf8.h"

namespace scb::golden {
namespace {

/// The number of bytes of the text's first character; 0 if XML does not allow it (section 2.2 of
/// the recommendation).
std::size_t character_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x20) return lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
    const std::string_view character = text.substr(0, scenes::utf8_length(text));
    return character == "\uFFFE" || character == "\uFFFF" ? 0 : character.size();
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

}  // namespace scb::golden
