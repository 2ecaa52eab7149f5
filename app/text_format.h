#pragma once

#include <string>

namespace scb {

/// What printf would print, as a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

}  // namespace scb
