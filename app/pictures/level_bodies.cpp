#include "app/pictures/level_bodies.h"

#include <algorithm>

#include "scb/error.h"

namespace scb::app {

std::vector<render::LevelBody> level_bodies(const std::vector<BodyAtFrame>& bodies,
                                            const std::vector<render::MeshHandle>& handles) {
    std::vector<render::LevelBody> result;
    std::uint32_t next_id = 1;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        render::LevelBody b;
        b.name = bodies[i].name;
        b.mesh = bodies[i].mesh.get();
        if (!handles.empty()) b.handle = handles[i];
        b.pose = bodies[i].pose;
        b.tree = bodies[i].tree.get();
        b.first_id = next_id;
        if (b.tree->size() > 0xffffffffu - next_id)
            throw InputError("the scene has more nodes than 32-bit ids; use fewer bodies.");
        next_id += static_cast<std::uint32_t>(b.tree->size());
        result.push_back(std::move(b));
    }
    return result;
}

render::LevelStyle level_style(const LevelOptions& options, const std::vector<BodyAtFrame>& bodies,
                               int deepest) {
    render::LevelStyle style;
    style.opacity = options.resolved_opacity();
    style.mesh = options.mesh || options.edges || style.opacity < 1;
    style.mesh_edges = options.edges;
    style.theme = options.picture.theme();
    double root_diameter = 0;
    for (const BodyAtFrame& body : bodies)
        root_diameter = std::max(root_diameter, render::root_diameter(*body.tree));
    style.colors = {options.resolved_color_by(bodies.size()), deepest, root_diameter};
    return style;
}

}  // namespace scb::app
