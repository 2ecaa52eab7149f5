#include "render/files/terminal_image.h"

#include <sixel.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "core/platform/base64.h"
#include "render/files/image_file.h"
#include "scb/error.h"

namespace scb::render {
namespace {

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [text](std::string_view word) { return text.starts_with(word); });
}

std::string encoded(const std::filesystem::path& png) {
    std::ifstream file(png, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.empty()) throw InputError(png.string() + ": this picture cannot be read.");
    return base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

/// The graphics protocol of kitty: parts of at most 4096 characters, m=1 before the last.
std::string kitty_text(const std::string& picture) {
    constexpr std::size_t most = 4096;
    std::string text;
    for (std::size_t at = 0; at < picture.size(); at += most)
        text += std::string("\033_G") + (at == 0 ? "a=T,f=100," : "") +
                (at + most < picture.size() ? "m=1;" : "m=0;") + picture.substr(at, most) +
                "\033\\";
    return text + "\n";
}

std::string sixel_text(const Image& image) {
    std::string text;
    const auto append = [](char* data, int size, void* to) {
        static_cast<std::string*>(to)->append(data, static_cast<std::size_t>(size));
        return size;
    };
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 != 3) rgb.push_back(image.rgba[i]);
    sixel_output_t* output = nullptr;
    sixel_dither_t* dither = nullptr;
    if (SIXEL_SUCCEEDED(sixel_output_new(&output, append, &text, nullptr)) &&
        SIXEL_SUCCEEDED(sixel_dither_new(&dither, 256, nullptr)) &&
        SIXEL_SUCCEEDED(sixel_dither_initialize(dither, rgb.data(), image.width, image.height,
                                                SIXEL_PIXELFORMAT_RGB888, SIXEL_LARGE_AUTO,
                                                SIXEL_REP_AUTO, SIXEL_QUALITY_HIGH)))
        sixel_encode(rgb.data(), image.width, image.height, 3, dither, output);
    if (dither != nullptr) sixel_dither_unref(dither);
    if (output != nullptr) sixel_output_unref(output);
    return text + "\n";
}

}  // namespace

TerminalImages terminal_images() {
    const std::string_view asked = variable("SCB_IMAGES"), term = variable("TERM"),
                           program = variable("TERM_PROGRAM");
    if (asked == "kitty") return TerminalImages::kitty;
    if (asked == "iterm2") return TerminalImages::iterm2;
    if (asked == "sixel") return TerminalImages::sixel;
    if (asked == "none" || ::isatty(STDOUT_FILENO) == 0) return TerminalImages::none;
    if (!variable("KITTY_WINDOW_ID").empty() || is_one_of(term, {"xterm-kitty", "xterm-ghostty"}))
        return TerminalImages::kitty;
    if (is_one_of(program, {"iTerm", "WezTerm", "mintty", "vscode"}) ||
        variable("LC_TERMINAL") == "iTerm2")
        return TerminalImages::iterm2;
    if (is_one_of(term, {"foot", "mlterm", "contour", "yaft", "xterm-sixel"}))
        return TerminalImages::sixel;
    return TerminalImages::none;
}

std::string terminal_image(TerminalImages how, const std::filesystem::path& png) {
    switch (how) {
        case TerminalImages::kitty:
            return kitty_text(encoded(png));
        case TerminalImages::iterm2:
            return "\033]1337;File=inline=1;preserveAspectRatio=1:" + encoded(png) + "\a\n";
        case TerminalImages::sixel:
            return sixel_text(read_png(png));
        case TerminalImages::none:
            break;
    }
    return "";
}

}  // namespace scb::render
