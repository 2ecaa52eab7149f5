#include "render/files/image_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    const fuzz::InputFile file(input);
    try {
        const render::Image image = render::read_png(file.path());
        fuzz::require(image.rgba.size() == 4 * static_cast<std::size_t>(image.width) *
                                               static_cast<std::size_t>(image.height),
                      "a picture has its pixels");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, file.path());
    }
}
