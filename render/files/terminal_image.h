#pragma once

#include <filesystem>
#include <string>

namespace scb::render {

/// The protocols with which terminals show pictures.
enum class TerminalImages { none, kitty, iterm2, sixel };

/// The protocol of the terminal on standard output, from environment variables that the terminal
/// sets, or from SCB_IMAGES: kitty, iterm2, sixel or none. `none` if it is not a terminal and
/// SCB_IMAGES is not set.
TerminalImages terminal_images();

/// The text that makes the terminal show the picture of a PNG file. Throws InputError if it cannot
/// be read.
std::string terminal_image(TerminalImages how, const std::filesystem::path& png);

}  // namespace scb::render
