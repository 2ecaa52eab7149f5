#pragma once

#include <filesystem>
#include <string>

#include "app/pictures/picture_options.h"
#include "render/draw/renderer.h"
#include "render/overlay/overlay_shape.h"

namespace scb::app {

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
