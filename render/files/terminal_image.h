#pragma once

#include <filesystem>
#include <string>

namespace scb::render {

/// How a terminal is told to show a picture.
enum class TerminalImages { none, kitty, iterm2, sixel };

/// What the terminal of the standard output understands, by the variables of the environment that
/// it sets, or as SCB_IMAGES says: kitty, iterm2, sixel or none. None where it is no terminal and
/// that variable is not set.
TerminalImages terminal_images();

/// What has the terminal show the picture of a PNG file. Throws InputError where it cannot be read.
std::string terminal_image(TerminalImages how, const std::filesystem::path& png);

}  // namespace scb::render
