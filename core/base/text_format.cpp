#include "core/base/text_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdarg>
#include <cstdint>
#include <cstdio>

namespace scb {

std::string format(const char* pattern, ...) {
    const CLocale with_points;
    va_list arguments, again;
    va_start(arguments, pattern);
    va_copy(again, arguments);
    const int size = std::vsnprintf(nullptr, 0, pattern, arguments);
    va_end(arguments);
    std::string text(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    // The terminating null goes where std::string has its own.
    std::vsnprintf(text.data(), text.size() + 1, pattern, again);
    va_end(again);
    return text;
}

std::size_t character_count(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

std::string left_aligned(const std::string& text, std::size_t width) {
    const std::size_t characters = character_count(text);
    return characters < width ? text + std::string(width - characters, ' ') : text;
}

std::string right_aligned(const std::string& text, std::size_t width) {
    const std::size_t characters = character_count(text);
    return characters < width ? std::string(width - characters, ' ') + text : text;
}

std::string exact_number(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return std::string(buffer.data(), end);
}

std::string short_hash(std::string_view text) {
    std::uint32_t hash = 0x811c9dc5;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
    return format("%08x", hash);
}

std::string count_text(std::uint64_t count) {
    std::string text = std::to_string(count);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string counted(std::uint64_t count, const char* one, const char* several) {
    return count_text(count) + " " + (count == 1 ? one : several);
}

}  // namespace scb
