#include "app/pictures/picture_texts.h"

#include "app/cli/command_text.h"
#include "core/platform/utf8.h"

namespace scb::app {
namespace {

/// Options that do not affect a picture.
const std::vector<std::string> untold = {"--output", "--models", "--jobs",   "--json",
                                         "--ids",    "--pick",   "--video",  "--fps",
                                         "--open",   "--shard",  "--merged", "--terminal"};

}  // namespace

std::vector<render::PngText> picture_texts(const PictureOptions& options,
                                           const std::string& scene) {
    std::vector<render::PngText> texts = {{"Software", "scb " SCB_VERSION}};
    // File names need not be UTF-8, and their line ends must not come into the text.
    if (!scene.empty()) texts.push_back({"Scene", printable(scene)});
    if (options.command)
        texts.push_back({"Command", printable(told_command(*options.command, untold))});
    return texts;
}

}  // namespace scb::app
