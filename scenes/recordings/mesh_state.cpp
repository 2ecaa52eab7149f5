#include "scenes/recordings/mesh_state.h"

#include <algorithm>
#include <utility>

#include "core/judge/engine_query.h"
#include "scenes/recordings/recording_summary.h"

namespace scb::scenes {
namespace {

/// See MeshState::finite.
Mesh made_finite(Mesh mesh) {
    const auto some = std::find_if(mesh.vertices.begin(), mesh.vertices.end(), is_usable);
    const Vec3 place = some == mesh.vertices.end() ? Vec3(Vec3::Zero()) : *some;
    for (Triangle& triangle : mesh.triangles) {
        // check_mesh reports vertices that do not exist.
        const auto is_known = [&mesh](std::uint32_t v) { return v < mesh.vertices.size(); };
        if (!std::all_of(triangle.begin(), triangle.end(), is_known)) continue;
        const auto broken =
            std::find_if(triangle.begin(), triangle.end(),
                         [&mesh](std::uint32_t v) { return !is_usable(mesh.vertices[v]); });
        if (broken == triangle.end()) continue;
        const std::uint32_t v = *broken;
        triangle = {v, v, v};
    }
    for (Vec3& vertex : mesh.vertices)
        if (!is_usable(vertex)) vertex = place;
    return mesh;
}

}  // namespace

bool MeshState::take(const RecordedMesh& record, int frame, const std::string& what) {
    auto made = std::make_shared<Mesh>();
    made->vertices.reserve(record.coordinates.size() / 3);
    for (std::size_t i = 0; i + 2 < record.coordinates.size(); i += 3)
        made->vertices.emplace_back(record.coordinates[i], record.coordinates[i + 1],
                                    record.coordinates[i + 2]);
    made->triangles.reserve(record.indices.size() / 3);
    for (std::size_t i = 0; i + 2 < record.indices.size(); i += 3)
        made->triangles.push_back(
            {record.indices[i], record.indices[i + 1], record.indices[i + 2]});
    std::shared_ptr<const Mesh> all_finite = made;
    if (!std::all_of(made->vertices.begin(), made->vertices.end(), is_usable))
        all_finite = std::make_shared<const Mesh>(made_finite(*made));
    check_mesh(*all_finite, what);
    const Box box = bounding_box(*all_finite);
    name = shown(record.name);
    const bool is_same = mesh && all_finite == made && mesh->vertices == made->vertices &&
                         mesh->triangles == made->triangles &&
                         coordinate_bytes == record.coordinate_bytes;
    if (is_same) return false;
    if (!rest || rest->vertices.size() != all_finite->vertices.size() ||
        rest->triangles != all_finite->triangles)
        rest = all_finite;
    mesh = std::move(made);
    finite = std::move(all_finite);
    coordinate_bytes = record.coordinate_bytes;
    reach = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
    recorded_at = frame;
    ++version;
    return true;
}

}  // namespace scb::scenes
