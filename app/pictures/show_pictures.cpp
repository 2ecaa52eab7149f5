#include "app/pictures/show_pictures.h"

#include "render/files/terminal_image.h"

namespace scb::app {

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

}  // namespace scb::app
