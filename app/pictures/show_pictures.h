#pragma once

#include <filesystem>
#include <vector>

#include "app/cli/console.h"

namespace scb::app {

/// Shows PNG files in the terminal, where it can; else a note says so.
void show_pictures(const std::vector<std::filesystem::path>& files, const Console& console);

}  // namespace scb::app
