#pragma once

#include <filesystem>

#include "app/cli/console.h"

namespace scb::app {

/// Opens a file or folder in the program that the desktop has for it, which then runs on. Where
/// there is nothing to open it with, or that fails, a note says so: the work is done all the same.
void open_file(const std::filesystem::path& file, const Console& console);

}  // namespace scb::app
