#pragma once

#include <filesystem>
#include <vector>

#include "app/cli/console.h"

namespace scb::app {

/// Shows PNG files in the terminal. If the terminal cannot show them, prints a note.
void show_pictures(const std::vector<std::filesystem::path>& files, const Console& console);

}  // namespace scb::app
