#pragma once

#include <imgui.h>

#include <cstdint>
#include <memory>

namespace scb::render {

/// The weights that texts are set in (Roboto).
enum class FontWeight { regular, medium, bold };

/// One weight at one size, rasterised at whole pixels.
struct FontFace {
    FontWeight weight;
    int size;                            ///< pixels from ascender to descender
    std::unique_ptr<ImFontAtlas> atlas;  ///< its TexID is the number below
    ImFont* font;
    std::uintptr_t number;  ///< unique among the faces of the process, from 1 on
};

/// Latin-1, Greek, general punctuation, arrows and mathematical operators, as far as the face has
/// them.
FontFace make_font_face(FontWeight weight, int size);

}  // namespace scb::render
