#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace scb {

/// The parts, one behind the other, as a stream writes them whatever locale the host program has.
template <class... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    (text << ... << parts);
    return text.str();
}

}  // namespace scb
