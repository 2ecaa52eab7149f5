#include "app/pictures/picture_options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <thread>

#include "app/cli/choice.h"
#include "app/cli/command.h"
#include "app/cli/command_text.h"
#include "app/cli/validators.h"
#include "app/query/query_options.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "core/platform/output_file.h"
#include "scb/error.h"

namespace scb::app {
namespace {

// Smaller pictures have no room for a heading and numbers, or show nothing. OpenGL libraries cannot
// draw larger ones.
constexpr int smallest_width = 320, smallest_height = 240, smallest_view = 64, largest = 16384;

int side_of(const std::string& size, std::size_t side) {
    const std::vector<std::string> parts = split_list(size, 'x');
    if (parts.size() != 2)
        throw InputError("--size " + size + ": give WIDTHxHEIGHT in pixels, such as 1280x720.");
    return whole_number(parts[side], "--size " + size);
}

/// Whether the name ends like a picture in a format that is not written here, or in capitals.
bool names_other_picture(const std::string& name) {
    std::string ending = std::filesystem::path(name).extension().string();
    if (ending == ".png") return false;
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::array endings = {".png",  ".jpg",  ".jpeg", ".gif", ".bmp", ".tif",
                                    ".tiff", ".webp", ".svg",  ".pdf", ".ppm"};
    return std::ranges::find(endings, ending) != endings.end();
}

}  // namespace

void PictureOptions::check() const {
    const int least_width = no_panel ? smallest_view : smallest_width,
              least_height = no_panel ? smallest_view : smallest_height;
    const int most = samples == 4 ? largest / 2 : largest;
    if (width() < least_width || height() < least_height || width() > most || height() > most)
        throw InputError("--size " + size + ": give " + std::to_string(least_width) + "x" +
                         std::to_string(least_height) + " to " + std::to_string(most) + "x" +
                         std::to_string(most) + " pixels" +
                         (samples == 4 && (width() > most || height() > most) &&
                                  width() <= largest && height() <= largest
                              ? ", or twice that with --samples 1."
                              : "."));
    // Options set by a program have not been checked by the parser.
    if (samples != 1 && samples != 4)
        throw InputError("--samples " + std::to_string(samples) + ": give 1 or 4.");
    if (background != "light" && background != "dark")
        throw InputError("--background " + background + ": give light or dark.");
    if (!render::gl_backend_from_string(gl))
        throw InputError("--gl " + gl + ": give osmesa or egl.");
    if (job_count < 0 || job_count > 256)
        throw InputError("--jobs " + std::to_string(job_count) + ": give 1 to 256.");
    if (names_other_picture(output))
        throw InputError("-o " + output + ": pictures are PNG files; name " +
                         (takes_file ? "a file .png, or a folder." : "a folder."));
    if (open && output.empty())
        throw InputError("--open: there is nothing to open; say where pictures go with -o DIR.");
    if (names_file() && !takes_file)
        throw InputError("-o " + output + ": this command writes several files; name a folder.");
    if (names_file() && (shards.is_shard() || shards.is_merge()))
        throw InputError("-o " + output + ": shards are kept and joined in folders; name one.");
}

void PictureOptions::check_count(std::size_t pictures, const std::string& one) const {
    if (names_file() && pictures > 1)
        throw InputError("-o " + output + ": this run draws " +
                         counted(pictures, "picture", "pictures") + "; name a folder, or " + one +
                         ".");
}

std::string PictureOptions::picture_stem(const std::string& usual) const {
    return names_file() ? std::filesystem::path(output).stem().string() : usual;
}

int PictureOptions::width() const { return side_of(size, 0); }
int PictureOptions::height() const { return side_of(size, 1); }

render::FigureLayout PictureOptions::layout() const {
    return render::figure_layout(width(), height(), !no_panel);
}

const render::Theme* PictureOptions::theme() const {
    return background == "dark" ? &render::dark_theme : &render::light_theme;
}

render::GlBackend PictureOptions::backend() const {
    return render::gl_backend_from_string(gl).value();
}

std::size_t PictureOptions::jobs() const {
    if (job_count > 0) return static_cast<std::size_t>(job_count);
    return std::max(1u, std::thread::hardware_concurrency());
}

std::filesystem::path PictureOptions::output_folder() const {
    std::filesystem::path folder = output;
    if (names_file() && (folder = folder.parent_path()).empty()) return folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw OutputError(folder.string() + ": this folder cannot be made" +
                          (error ? " (" + error.message() + ")" : "") + "; name another with -o.");
    return folder;
}

void add_gl_option(const Command& command, std::string& gl) {
    add_choice(command, "--gl", gl, words_as_choices({"osmesa", "egl"}),
               "OpenGL context: osmesa or egl")
        .type_name("NAME")
        .shareable();
}

namespace {

constexpr const char* picture_output =
    "Folder for the pictures, with index.json; or FILE.png for the only picture, without it";

/// Options that do not affect a picture.
const std::vector<std::string> untold = {"--output", "--models", "--jobs",   "--json",
                                         "--ids",    "--pick",   "--video",  "--fps",
                                         "--open",   "--shard",  "--merged", "--terminal"};

void add_output_size(const Command& command, PictureOptions& options, const char* files) {
    options.shown_command = [command] { return shown_command(command, untold); };
    const Option output =
        command.add_option("-o,--output", options.output, files).folder().only_typed();
    if (!options.output.empty()) output.show_default();
    command
        .add_flag("--open", options.open,
                  "Open the result in the desktop's default program for such files. If there are "
                  "several pictures, open their folder")
        .only_typed();
    command.add_option("--size", options.size, "Size of a picture in pixels")
        .type_name("WxH")
        .show_default()
        .shareable();
}

void add_view(const Command& command, PictureOptions& options, CameraOptions& camera) {
    command
        .add_option(
            "--camera", camera.camera,
            "fit, orbit:AZIMUTH,ELEVATION[,DISTANCE[,X,Y,Z]] in degrees, or a JSON file; default: "
            "the scene's camera")
        .file({".json"})
        .offer({"fit", "orbit:"})
        .type_name("CAMERA")
        .shareable();
    add_choice(command, "--up", camera.up, words_as_choices({"x", "y", "z"}),
               "The axis that points up: x, y or z. Default z; y of glTF files")
        .type_name("AXIS")
        .shareable();
    command.add_flag("--ortho", camera.orthographic, "Orthographic instead of perspective")
        .shareable();
    command
        .add_option("--clip", camera.clip,
                    "Draw only one side of a plane: points p of the world with (X,Y,Z).p <= D")
        .type_name("X,Y,Z,D")
        .shareable();
    add_choice(command, "--samples", options.samples, {{"1", 1}, {"4", 4}},
               "Samples per pixel: 1 or 4")
        .type_name("N")
        .shareable();
}

void add_drawing(const Command& command, PictureOptions& options) {
    add_choice(command, "--background", options.background, words_as_choices({"light", "dark"}),
               "light or dark")
        .type_name("THEME")
        .shareable();
    add_gl_option(command, options.gl);
    command
        .add_flag("--shift-color", options.shift_color,
                  "An error on purpose, for `scb golden selftest`")
        .hide();
}

void add_jobs(const Command& command, PictureOptions& options) {
    command
        .add_option("--jobs", options.job_count,
                    "Number of threads that compress pictures; 0 is one per core")
        .check(decimal_number)
        .show_default();
}

/// Outputs of pictures besides their files.
void add_copies(const Command& command, PictureOptions& options) {
    command
        .add_flag("--svg", options.svg,
                  "Also write each picture as SVG: text and plots as vectors, views of the scene "
                  "as images")
        .shareable();
    command.add_flag("--terminal", options.show,
                     "Also show the pictures in the terminal, if it supports the protocol of kitty "
                     "or iTerm2, or sixel");
}

void add_json(const Command& command, PictureOptions& options) {
    command.add_flag("--json", options.json, "Print index.json instead of the file names")
        .shareable();
}

}  // namespace

void add_picture_options(const Command& command, PictureOptions& options, CameraOptions& camera) {
    add_output_size(command, options, picture_output);
    add_view(command, options, camera);
    add_drawing(command, options);
    add_jobs(command, options);
    command
        .add_flag("--ids", options.ids,
                  "Also write which node owns each pixel (PNG, ids as RGBA bytes)")
        .shareable();
    add_copies(command, options);
    add_json(command, options);
}

void add_panel_option(const Command& command, PictureOptions& options) {
    command
        .add_flag("--no-panel", options.no_panel,
                  "The view alone, without heading, numbers and legend")
        .shareable();
}

void add_picture_options(const Command& command, PictureOptions& options) {
    // Only the overlay is drawn, which is not sampled.
    options.samples = 1;
    add_output_size(command, options, picture_output);
    add_drawing(command, options);
    add_jobs(command, options);
    add_copies(command, options);
    add_json(command, options);
}

void add_page_options(const Command& command, PictureOptions& options, CameraOptions& camera,
                      const char* page) {
    add_output_size(command, options, page);
    command.get_option("--output").file({".html"});
    command.get_option("--size").description("Size of the still picture in pixels");
    add_view(command, options, camera);
    add_drawing(command, options);
}

void add_figure_options(const Command& command, PictureOptions& options, const char* files) {
    add_output_size(command, options, files);
    add_drawing(command, options);
    add_copies(command, options);
}

}  // namespace scb::app
