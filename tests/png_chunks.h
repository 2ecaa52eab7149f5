#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace scb {

/// What the text chunks of a PNG file say, by keyword.
inline std::map<std::string, std::string> png_texts(const std::string& png);

/// The file without them: what is the same wherever a picture is the same.
inline std::string png_without_texts(const std::string& png);

namespace detail {

/// Calls `use(type, content, whole)` for each chunk of a valid PNG.
template <class Use>
void for_each_chunk(const std::string& png, Use use) {
    constexpr std::size_t signature = 8, around = 12;
    std::size_t at = signature;
    while (at + around <= png.size()) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | static_cast<unsigned char>(png[at + i]);
        use(png.substr(at + 4, 4), png.substr(at + 8, length), png.substr(at, length + around));
        at += length + around;
    }
}

}  // namespace detail

inline std::map<std::string, std::string> png_texts(const std::string& png) {
    std::map<std::string, std::string> texts;
    detail::for_each_chunk(
        png, [&](const std::string& type, const std::string& content, const std::string&) {
            const std::size_t end = content.find('\0');
            // Behind the keyword of iTXt: two flags, and two empty texts with their ends.
            if (type == "tEXt") texts[content.substr(0, end)] = content.substr(end + 1);
            if (type == "iTXt") texts[content.substr(0, end)] = content.substr(end + 5);
        });
    return texts;
}

inline std::string png_without_texts(const std::string& png) {
    std::string rest = png.substr(0, 8);
    detail::for_each_chunk(
        png, [&](const std::string& type, const std::string&, const std::string& whole) {
            if (type != "tEXt" && type != "iTXt") rest += whole;
        });
    return rest;
}

}  // namespace scb
