#pragma once

#include <sstream>
#include <string>

namespace scb {

/// The parts, one behind the other, as a stream writes them.
template <class... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

}  // namespace scb
