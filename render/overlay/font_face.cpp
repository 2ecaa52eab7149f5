#include "render/overlay/font_face.h"

#include <imgui_internal.h>

#include <atomic>
#include <string_view>

#include "render/gl/embedded.h"

SCB_DECLARE_EMBEDDED(roboto_regular)
SCB_DECLARE_EMBEDDED(roboto_medium)
SCB_DECLARE_EMBEDDED(roboto_bold)

namespace scb::render {

namespace {

constexpr ImWchar glyph_ranges[] = {0x0020, 0x00FF,  // Latin-1
                                    0x0370, 0x03FF,  // Greek
                                    0x2010, 0x2027,  // dashes, quotation marks, dots
                                    0x2032, 0x2033,  // primes
                                    0x2190, 0x2193,  // arrows
                                    0x2200, 0x22FF,  // mathematical operators
                                    0};

std::string_view font_file(FontWeight weight) {
    switch (weight) {
        case FontWeight::medium:
            return SCB_EMBEDDED(roboto_medium);
        case FontWeight::bold:
            return SCB_EMBEDDED(roboto_bold);
        case FontWeight::regular:
            break;
    }
    return SCB_EMBEDDED(roboto_regular);
}

/// "--frames" has two hyphens, not one long dash.
void keep_hyphens_apart(ImFont& font) {
    auto* hyphen = const_cast<ImFontGlyph*>(font.FindGlyphNoFallback('-'));
    if (hyphen == nullptr || hyphen->AdvanceX + hyphen->X0 - hyphen->X1 >= 1) return;
    hyphen->AdvanceX += 1;
    font.IndexAdvanceX['-'] = hyphen->AdvanceX;
}

}  // namespace

FontFace make_font_face(FontWeight weight, int size) {
    static std::atomic<std::uintptr_t> next_number = 1;
    FontFace face{weight, size, std::make_unique<ImFontAtlas>(), nullptr, next_number++};
    // Set explicitly, so that pixels do not depend on how ImGui was built.
    face.atlas->FontBuilderIO = ImFontAtlasGetBuilderForStbTruetype();
    face.atlas->Flags = ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;

    const std::string_view file = font_file(weight);
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;  // one texel is one pixel
    config.GlyphRanges = glyph_ranges;
    // ImGui only reads it.
    face.font = face.atlas->AddFontFromMemoryTTF(const_cast<char*>(file.data()),
                                                 static_cast<int>(file.size()),
                                                 static_cast<float>(size), &config);
    face.atlas->Build();
    keep_hyphens_apart(*face.font);
    face.atlas->SetTexID(reinterpret_cast<ImTextureID>(face.number));
    return face;
}

}  // namespace scb::render
