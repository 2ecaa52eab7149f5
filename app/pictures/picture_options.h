#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/pictures/scene_camera.h"
#include "app/pictures/video_options.h"
#include "app/shards/shard_options.h"
#include "render/gl/context.h"
#include "render/overlay/figure_layout.h"
#include "render/view/palette.h"

namespace scb::app {

class Command;

/// A pixel, from the left and from the top.
struct PixelPosition {
    int x = 0, y = 0;
};

/// Options of every command that draws.
struct PictureOptions {
    std::string size = "1280x720";
    int samples = 4;
    std::string background = "light";
    std::string gl = render::is_compiled_in(render::GlBackend::osmesa) ? "osmesa" : "egl";
    std::string output = "out";
    bool takes_file = false;  ///< -o may name the only picture, FILE.png
    int job_count = 0;
    bool ids = false;
    bool json = false;
    bool show = false;                    ///< pictures are shown in the terminal
    bool open = false;                    ///< the result is opened, see open_file
    bool no_panel = false;                ///< only the view
    bool svg = false;                     ///< each picture also as SVG
    bool shift_color = false;             ///< an invisible error for `scb golden selftest`
    std::optional<PixelPosition> pick{};  ///< the pixel whose content is to be printed
    VideoOptions video{};
    ShardOptions shards{};
    std::function<std::string()> shown_command{};  ///< for the text in PNG files; may be empty

    /// Throws InputError if an option is invalid.
    void check() const;
    /// Throws InputError if -o names one picture and the run draws several. `one`: what to do to
    /// draw one.
    void check_count(std::size_t pictures, const std::string& one) const;

    /// Whether -o names the only picture in place of a folder.
    bool names_file() const { return output.ends_with(".png"); }
    /// The name of a picture without its ending: the file's that -o names, or `usual` in a folder.
    std::string picture_stem(const std::string& usual) const;
    int width() const;
    int height() const;
    /// For a picture with one view.
    render::FigureLayout layout() const;
    const render::Theme* theme() const;
    render::GlBackend backend() const;
    std::size_t jobs() const;
    /// The folder of the pictures, created if missing; throws OutputError if that fails.
    std::filesystem::path output_folder() const;
};

void add_picture_options(const Command& command, PictureOptions& options, CameraOptions& camera);
/// Only --gl.
void add_gl_option(const Command& command, std::string& gl);
/// --no-panel.
void add_panel_option(const Command& command, PictureOptions& options);
/// For pictures without a view of the scene: neither camera nor samples nor ids.
void add_picture_options(const Command& command, PictureOptions& options);
/// For a page with one picture in it: a file in place of the folder.
void add_page_options(const Command& command, PictureOptions& options, CameraOptions& camera,
                      const char* page);
/// For pictures that accompany tables: `files` describes them. Without -o there are none.
void add_figure_options(const Command& command, PictureOptions& options, const char* files);

}  // namespace scb::app
