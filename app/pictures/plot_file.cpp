#include "app/pictures/plot_file.h"

#include "app/pictures/picture_texts.h"
#include "core/platform/output_file.h"
#include "render/files/image_file.h"
#include "render/overlay/overlay_shape.h"

namespace scb::app {

void PlotFile::write(const render::Picture& picture, render::Renderer& renderer,
                     const std::filesystem::path& file, const std::string& scene) const {
    write_file_whole(file, render::encode_png(renderer.draw(picture, &overlay).image,
                                              picture_texts(options_, scene)));
    if (options_.svg)
        write_file_whole(std::filesystem::path(file).replace_extension(".svg"),
                         render::svg_text(shapes_, picture, nullptr));
}

}  // namespace scb::app
