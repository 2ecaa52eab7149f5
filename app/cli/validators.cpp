#include "app/cli/validators.h"

#include <charconv>
#include <cstdint>

namespace scb::app {
namespace {

template <class Number>
bool parses_as(const std::string& text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    return parsed.ec == std::errc() && parsed.ptr == end;
}

}  // namespace

std::string decimal_number(const std::string& text) {
    const std::size_t sign = text.starts_with('-') ? 1 : 0;
    const bool padded = text.size() > sign + 1 && text[sign] == '0';
    return parses_as<std::int64_t>(text) && !padded ? "" : "'" + text + "' is not a whole number";
}

std::string real_number(const std::string& text) {
    return parses_as<double>(text) ? "" : "'" + text + "' is not a number";
}

}  // namespace scb::app
