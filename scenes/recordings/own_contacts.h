#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "core/judge/engine_query.h"
#include "scb/hierarchy.h"

namespace scb::scenes {

/// The pairs of triangles that this project finds for the queries of a recording, by hierarchies of
/// its own, each of which is built once; of objects those of object_contacts.
class OwnContacts {
  public:
    using Meshes = std::array<std::shared_ptr<const Mesh>, 2>;

    /// Sorted, of finite triangles; of a body against itself those of SelfPairs; none where a side
    /// has no mesh, and where a body has no pose. `meshes`: those of the query's bodies, all of
    /// them finite.
    std::vector<IndexPair> contacts(const EngineQuery& query, const Meshes& meshes);

  private:
    /// A mesh that is recorded anew must not get the address of one that is known here, so these
    /// are held.
    struct Built {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const Hierarchy<Obb>> hierarchy;
    };

    std::shared_ptr<const Hierarchy<Obb>> hierarchy_of(const std::shared_ptr<const Mesh>& mesh);

    std::map<const Mesh*, Built> built_;  ///< lookups, and forgetting
    std::size_t forget_at_ = 16;          ///< of so many, those that nobody else has are forgotten
};

}  // namespace scb::scenes
