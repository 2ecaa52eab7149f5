#include "app/pictures/shifted_colors.h"

namespace scb::app {

render::Picture shifted_colors(render::Picture picture) {
    const auto shift = [](render::Rgba8& color) {
        color.g = static_cast<std::uint8_t>(color.g < 255 ? color.g + 1 : color.g - 1);
    };
    for (render::Pane& pane : picture.panes) {
        for (render::VolumeInstance& volume : pane.volumes) shift(volume.color);
        for (render::MeshDraw& mesh : pane.meshes) {
            shift(mesh.color);
            for (render::Rgba8& color : mesh.triangle_colors) shift(color);
        }
    }
    return picture;
}

}  // namespace scb::app
