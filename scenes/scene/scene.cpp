#include "scenes/scene/scene.h"

#include <algorithm>
#include <string_view>

#include "core/base/text_format.h"

namespace scb::scenes {
std::string file_name_of(const std::string& text) {
    constexpr std::string_view allowed =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
    constexpr std::size_t longest = 100;  // leaves room for the suffixes of files
    std::string name;
    for (const char c : text) {
        if (name.size() == longest) break;
        const bool is_allowed = allowed.find(c) != std::string_view::npos;
        if (is_allowed || (!name.empty() && name.back() != '-')) name += is_allowed ? c : '-';
    }
    // A leading dot hides files, a leading dash reads as an option, and neither end needs them.
    while (!name.empty() && (name.front() == '.' || name.front() == '-')) name.erase(0, 1);
    while (!name.empty() && (name.back() == '.' || name.back() == '-')) name.pop_back();
    const bool is_cut = text.size() > longest,
               has_others = std::any_of(text.begin(), text.end(), [](char c) {
                   return static_cast<unsigned char>(c) >= 128;
               });
    if (name.empty()) name = "scene";
    if (!is_cut && !has_others) return name;
    const std::string hash = "-" + short_hash(text);
    return name.substr(0, longest - hash.size()) + hash;
}

}  // namespace scb::scenes
