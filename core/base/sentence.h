#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace scb {

/// The parts in sequence, as a stream writes them, independent of the host program's locale.
template <class... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    (text << ... << parts);
    return text.str();
}

}  // namespace scb
