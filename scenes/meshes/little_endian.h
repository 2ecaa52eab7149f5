#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scb::scenes {

/// The number of `size` bytes, 4 at most, the least one first; bytes behind the end are 0.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
}

}  // namespace scb::scenes
