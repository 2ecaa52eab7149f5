#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/pictures/scene_camera.h"
#include "app/pictures/video_options.h"
#include "app/shards/shard_options.h"
#include "render/gl/context.h"
#include "render/overlay/figure_layout.h"
#include "render/view/palette.h"

namespace scb::app {

/// A pixel, from the left and from the top.
struct PixelPosition {
    int x = 0, y = 0;
};

/// What every command that draws understands.
struct PictureOptions {
    std::string size = "1280x720";
    int samples = 4;
    std::string background = "light";
    std::string gl = render::is_compiled_in(render::GlBackend::osmesa) ? "osmesa" : "egl";
    std::string output = "out";
    int job_count = 0;
    bool ids = false;
    bool json = false;
    bool show = false;                    ///< pictures are shown in the terminal
    bool open = false;                    ///< what was made is opened, see open_file
    bool no_panel = false;                ///< the view alone
    bool svg = false;                     ///< each picture as SVG too
    bool shift_color = false;             ///< see shifted_colors
    std::optional<PixelPosition> pick{};  ///< the pixel to be identified: what it shows is printed
    VideoOptions video{};
    ShardOptions shards{};
    std::optional<Command> command{};  ///< whose options these are

    /// Throws InputError where one of them makes no sense.
    void check() const;

    int width() const;
    int height() const;
    /// Of a picture with one view.
    render::FigureLayout layout() const;
    const render::Theme* theme() const;
    render::GlBackend backend() const;
    std::size_t jobs() const;
    /// The folder, made where it was missing; throws OutputError where that fails.
    std::filesystem::path output_folder() const;
};

void add_picture_options(const Command& command, PictureOptions& options, CameraOptions& camera);
/// --gl alone.
void add_gl_option(const Command& command, std::string& gl);
/// Whether there is anything beside the view.
void add_panel_option(const Command& command, PictureOptions& options);
/// Of pictures without a view of the scene: neither camera nor samples nor ids.
void add_picture_options(const Command& command, PictureOptions& options);
/// Of a page that has one picture in it: a file in place of the folder.
void add_page_options(const Command& command, PictureOptions& options, CameraOptions& camera,
                      const char* page);
/// Of the pictures that go with tables into a folder: `files` says which, and without -o there are
/// none.
void add_figure_options(const Command& command, PictureOptions& options, const char* files);

}  // namespace scb::app
