#pragma once

#include <array>
#include <charconv>
#include <string>

namespace scb {

/// The shortest decimal text that reads back as the same double; "inf" and "nan" for those.
inline std::string number_text(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return std::string(buffer.data(), end);
}

}  // namespace scb
