#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace scb {

/// The bytes as text: base 64 of RFC 4648, section 4, with padding and without line ends.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace scb
