#include "core/hierarchy/node_surfaces.h"

#include "core/geometry/surface.h"

namespace scb {

std::vector<double> node_surfaces(const TreeShape& shape, const Mesh& mesh) {
    std::vector<double> surfaces(shape.size());
    for (std::size_t i = 0; i < shape.holder.size(); ++i) {
        if (shape.holder[i] == no_index) continue;
        const Triangle& t = mesh.triangles[i];
        surfaces[shape.holder[i]] +=
            triangle_moments(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]).area;
    }
    for (auto i = shape.order.rbegin(); i != shape.order.rend(); ++i)
        if (shape.parents[*i] != no_index) surfaces[shape.parents[*i]] += surfaces[*i];
    return surfaces;
}

}  // namespace scb
