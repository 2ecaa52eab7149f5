#include "app/pictures/plot_file.h"

#include "core/platform/output_file.h"
#include "core/platform/utf8.h"
#include "render/files/terminal_image.h"
#include "render/overlay/overlay_shape.h"

namespace scb::app {

std::vector<render::PngText> picture_texts(const PictureOptions& options,
                                           const std::string& scene) {
    std::vector<render::PngText> texts = {{"Software", "scb " SCB_VERSION}};
    // File names need not be UTF-8, and their line ends must not come into the text.
    if (!scene.empty()) texts.push_back({"Scene", printable(scene)});
    if (options.shown_command) texts.push_back({"Command", printable(options.shown_command())});
    return texts;
}

void show_pictures(const std::vector<std::filesystem::path>& files, const Console& console) {
    const render::TerminalImages how = render::terminal_images();
    if (how == render::TerminalImages::none) {
        console.note(
            "scb: --terminal: this terminal is not known to show pictures; if it does, set "
            "SCB_IMAGES to kitty, iterm2 or sixel.");
        return;
    }
    for (const std::filesystem::path& file : files) print_result(render::terminal_image(how, file));
}

void PlotFile::write(const render::Picture& picture, render::Renderer& renderer,
                     const std::filesystem::path& file, const std::string& scene) const {
    write_file_whole(file, render::encode_png(renderer.draw(picture, &overlay).image,
                                              picture_texts(options_, scene)));
    if (options_.svg)
        write_file_whole(std::filesystem::path(file).replace_extension(".svg"),
                         render::svg_text(shapes_, picture, nullptr));
}

}  // namespace scb::app
