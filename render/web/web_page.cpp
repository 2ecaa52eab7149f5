#include "render/web/web_page.h"

#include <nettle/sha2.h>

#include <array>
#include <string_view>
#include <utility>

#include "core/platform/base64.h"
#include "render/gl/embedded.h"

SCB_DECLARE_EMBEDDED(web_html)
SCB_DECLARE_EMBEDDED(web_css)
SCB_DECLARE_EMBEDDED(web_script)
SCB_DECLARE_EMBEDDED(web_volume_vert)
SCB_DECLARE_EMBEDDED(web_rounded_vert)
SCB_DECLARE_EMBEDDED(web_segment_vert)
SCB_DECLARE_EMBEDDED(segment_frag)
SCB_DECLARE_EMBEDDED(eye_glsl)
SCB_DECLARE_EMBEDDED(light_glsl)
SCB_DECLARE_EMBEDDED(volume_glsl)
SCB_DECLARE_EMBEDDED(scb_frag)
SCB_DECLARE_EMBEDDED(scb2_frag)
SCB_DECLARE_EMBEDDED(obb_frag)
SCB_DECLARE_EMBEDDED(polytope_frag)
SCB_DECLARE_EMBEDDED(convex_frag)
SCB_DECLARE_EMBEDDED(mesh_vert)
SCB_DECLARE_EMBEDDED(mesh_frag)

namespace scb::render {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const std::string_view special = "<>&\"'";
        if (special.find(c) == std::string_view::npos)
            result += c;
        else
            result += "&#" + std::to_string(static_cast<int>(c)) + ";";
    }
    return result;
}

/// JSON inside a script element: what could end it is written otherwise.
std::string inside_script(std::string_view json) {
    std::string result;
    for (const char c : json) {
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    }
    return result;
}

std::string hash_source(std::string_view text) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    return "'sha256-" + base64(digest) + "'";
}

/// The shaders that pictures are drawn with, and the two that put volumes in their place here.
std::string shader_elements() {
    const std::pair<const char*, std::string_view> shaders[] = {
        {"eye.glsl", SCB_EMBEDDED(eye_glsl)},
        {"light.glsl", SCB_EMBEDDED(light_glsl)},
        {"volume.glsl", SCB_EMBEDDED(volume_glsl)},
        {"scb.frag", SCB_EMBEDDED(scb_frag)},
        {"scb2.frag", SCB_EMBEDDED(scb2_frag)},
        {"box.frag", SCB_EMBEDDED(obb_frag)},
        {"polytope.frag", SCB_EMBEDDED(polytope_frag)},
        {"rounded.frag", SCB_EMBEDDED(convex_frag)},
        {"mesh.vert", SCB_EMBEDDED(mesh_vert)},
        {"mesh.frag", SCB_EMBEDDED(mesh_frag)},
        {"volume.vert", SCB_EMBEDDED(web_volume_vert)},
        {"rounded.vert", SCB_EMBEDDED(web_rounded_vert)},
        {"segment.vert", SCB_EMBEDDED(web_segment_vert)},
        {"segment.frag", SCB_EMBEDDED(segment_frag)},
    };
    std::string text;
    for (const auto& [name, source] : shaders)
        text += "<script type=\"text/plain\" id=\"" + std::string(name) + "\">" +
                std::string(source) + "</script>\n";
    return text;
}

}  // namespace

std::string web_page(const WebPage& page, const BlockStore& store) {
    std::string blocks;
    for (std::size_t i = 0; i < store.blocks().size(); ++i) {
        const BlockStore::Block& block = store.blocks()[i];
        static constexpr const char* types[] = {"u8", "u32", "f32", "f64"};
        blocks += "<script type=\"text/plain\" class=\"block\" data-type=\"" +
                  std::string(types[static_cast<std::size_t>(block.type)]) + "\" data-count=\"" +
                  std::to_string(block.count) + "\">" + block.text + "</script>\n";
    }
    const std::string style(SCB_EMBEDDED(web_css)), code(SCB_EMBEDDED(web_script));
    const std::pair<std::string_view, std::string> parts[] = {
        {"@STYLE_HASH@", hash_source(style)},
        {"@SCRIPT_HASH@", hash_source(code)},
        {"@THEME@", escaped(page.theme)},
        {"@TITLE@", escaped(page.title)},
        {"@DESCRIPTION@", escaped(page.description)},
        {"@STYLE@", style},
        {"@STILL@", base64(page.still)},
        {"@MANIFEST@", inside_script(page.manifest)},
        {"@SHADERS@", shader_elements()},
        {"@BLOCKS@", std::move(blocks)},
        {"@SCRIPT@", code},
    };
    // Each stands in the template once or twice, in this order: what is put in is not searched.
    std::string result;
    std::string_view left = SCB_EMBEDDED(web_html);
    while (!left.empty()) {
        std::size_t at = std::string_view::npos;
        const std::pair<std::string_view, std::string>* first = nullptr;
        for (const auto& part : parts)
            if (const std::size_t found = left.find(part.first); found < at) {
                at = found;
                first = &part;
            }
        result += left.substr(0, at);
        if (!first) break;
        result += first->second;
        left.remove_prefix(at + first->first.size());
    }
    return result;
}

}  // namespace scb::render
