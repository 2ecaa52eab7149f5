#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/web/block_store.h"

namespace scb::render {

/// What the page of `scb view` is made of.
struct WebPage {
    std::string title, description;   ///< UTF-8, any text
    std::string manifest;             ///< a JSON object: what blocks mean, see web/main.js
    std::vector<std::uint8_t> still;  ///< a PNG file: what a browser shows that cannot draw
    std::string theme{};              ///< "light", "dark"; empty: the reader's
};

/// One HTML file that fetches nothing: data, shaders, script and style are in it. Its content
/// security policy names the hashes of its own script and style and allows no other.
std::string web_page(const WebPage& page, const BlockStore& store);

}  // namespace scb::render
