#include "scenes/recordings/own_contacts.h"

#include <algorithm>

#include "core/judge/object_contacts.h"
#include "scb/collide.h"

namespace scb::scenes {

std::vector<IndexPair> OwnContacts::contacts(const EngineQuery& query, const Meshes& meshes) {
    if (has_object_volumes(query)) return object_contacts(query);
    const auto& [a, b] = query.sides;
    if (!a.mesh || !b.mesh || !query.rigid || query.self) return {};
    keep(meshes);
    return collide(Collider<Obb>{*hierarchy_of(*a.mesh, meshes), *a.mesh},
                   Collider<Obb>{*hierarchy_of(*b.mesh, meshes), *b.mesh}, query.b_to_a)
        .pairs;
}

void OwnContacts::keep(const Meshes& meshes) {
    std::erase_if(built_, [&](const Built& built) {
        return std::none_of(meshes.begin(), meshes.end(),
                            [&](const auto& mesh) { return mesh.second.mesh == built.mesh; });
    });
}

std::shared_ptr<const Hierarchy<Obb>> OwnContacts::hierarchy_of(const Mesh& mesh,
                                                                const Meshes& meshes) {
    for (const Built& built : built_)
        if (built.mesh.get() == &mesh) return built.hierarchy;
    const auto told = std::find_if(meshes.begin(), meshes.end(), [&mesh](const auto& state) {
        return state.second.mesh.get() == &mesh;
    });
    built_.push_back(
        {told->second.mesh, std::make_shared<const Hierarchy<Obb>>(build_hierarchy<Obb>(mesh))});
    return built_.back().hierarchy;
}

}  // namespace scb::scenes
