#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/pictures/picture_options.h"
#include "render/draw/renderer.h"
#include "render/files/image_file.h"
#include "render/overlay/overlay_shape.h"

namespace scb::app {

/// Texts in the PNG files of a run: the program and its version, the scene (none if empty), and the
/// command. They are the same on every machine, since they name files without folders.
std::vector<render::PngText> picture_texts(const PictureOptions& options, const std::string& scene);

/// Shows PNG files in the terminal. If the terminal cannot show them, prints a note.
void show_pictures(const std::vector<std::filesystem::path>& files, const Console& console);

/// A plot that accompanies tables.
class PlotFile {
  public:
    explicit PlotFile(const PictureOptions& options) : options_(options) {
        if (options.svg) overlay.note_in(&shapes_);
    }

    render::Overlay overlay;

    /// Writes FILE as PNG, and as SVG if asked for. `scene`: see picture_texts.
    void write(const render::Picture& picture, render::Renderer& renderer,
               const std::filesystem::path& file, const std::string& scene) const;

  private:
    const PictureOptions& options_;
    render::OverlayShapes shapes_;
};

/// Draws a figure of the options' size and theme, and writes it.
template <class Figure>
void write_plot(Figure figure, const PictureOptions& options, render::Renderer& renderer,
                const std::filesystem::path& file, const std::string& scene) {
    PlotFile plot(options);
    figure.theme = options.theme();
    plot.write(compose(figure, options.width(), options.height(), plot.overlay), renderer, file,
               scene);
}

}  // namespace scb::app
