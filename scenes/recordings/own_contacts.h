#pragma once

#include <map>
#include <memory>
#include <vector>

#include "scb/hierarchy.h"
#include "scenes/recordings/recorded_queries.h"

namespace scb::scenes {

/// The pairs of triangles that this project finds for the queries of a recording, by hierarchies of
/// its own, each of which is built once; of objects those of object_contacts.
class OwnContacts {
  public:
    using Meshes = std::map<std::uint32_t, MeshState>;

    /// Sorted; none where a side has no mesh, where the pose is not rigid, and of a body against
    /// itself. `meshes`: those that there are now.
    std::vector<IndexPair> contacts(const EngineQuery& query, const Meshes& meshes);

  private:
    /// A mesh that is told anew must not get the address of one that is known here, so these are
    /// held.
    struct Built {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const Hierarchy<Obb>> hierarchy;
    };

    /// Forgets meshes that there are no more.
    void keep(const Meshes& meshes);
    std::shared_ptr<const Hierarchy<Obb>> hierarchy_of(const Mesh& mesh, const Meshes& meshes);

    std::vector<Built> built_;
};

}  // namespace scb::scenes
