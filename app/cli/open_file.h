#pragma once

#include <filesystem>

#include "app/cli/console.h"

namespace scb::app {

/// Opens a file or folder in the desktop's program for it, which keeps running. If there is no such
/// program, or it fails, prints a note: the results are valid all the same.
void open_file(const std::filesystem::path& file, const Console& console);

}  // namespace scb::app
