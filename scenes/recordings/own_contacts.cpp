#include "scenes/recordings/own_contacts.h"

#include <algorithm>

#include "core/judge/query_contacts.h"
#include "core/judge/self_pairs.h"
#include "scb/collide.h"

namespace scb::scenes {

std::vector<IndexPair> OwnContacts::contacts(const EngineQuery& query, const Meshes& meshes) {
    if (!query.placed) return {};
    if (has_object_volumes(query)) return object_contacts(query);
    if (!meshes[0] || !meshes[1]) return {};
    std::vector<IndexPair> pairs;
    if (query.self)
        pairs = SelfPairs(*meshes[0], query.sides[0].rest ? *query.sides[0].rest : *meshes[0])
                    .all(*hierarchy_of(meshes[0]));
    else
        pairs = collide(Collider<Obb>{*hierarchy_of(meshes[0]), *meshes[0]},
                        Collider<Obb>{*hierarchy_of(meshes[1]), *meshes[1]}, query.b_to_a)
                    .pairs;
    const auto is_broken = [&query](const IndexPair& pair) {
        return !has_finite_corners(*query.sides[0].mesh, pair.a) ||
               !has_finite_corners(*query.sides[1].mesh, pair.b);
    };
    std::erase_if(pairs, is_broken);
    return pairs;
}

std::shared_ptr<const Hierarchy<Obb>> OwnContacts::hierarchy_of(
    const std::shared_ptr<const Mesh>& mesh) {
    if (const auto known = built_.find(mesh.get()); known != built_.end())
        return known->second.hierarchy;
    if (built_.size() >= forget_at_) {
        std::erase_if(built_, [](const auto& built) { return built.second.mesh.use_count() == 1; });
        forget_at_ = std::max<std::size_t>(16, 2 * built_.size());
    }
    auto hierarchy = std::make_shared<const Hierarchy<Obb>>(build_hierarchy<Obb>(*mesh));
    return built_.emplace(mesh.get(), Built{mesh, std::move(hierarchy)}).first->second.hierarchy;
}

}  // namespace scb::scenes
