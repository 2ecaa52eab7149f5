#pragma once

#include <filesystem>
#include <string>

#include "render/view/palette.h"

namespace scb {

/// "#0072B2".
std::string gnuplot_color(render::Rgba8 color);

/// A text in single quotes, as gnuplot reads it.
std::string gnuplot_text(const std::string& text);

/// Writes the script to `folder/name`, and runs gnuplot on it there. Returns an empty text, or a
/// note that gnuplot is missing. Throws OutputError if the script cannot be written, or gnuplot
/// fails.
std::string draw_plot(const std::filesystem::path& folder, const std::string& name,
                      const std::string& script);

}  // namespace scb
