#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "core/judge/answer_check.h"
#include "scb/hierarchy.h"

namespace scb::scenes {

/// Computes the exact answers of a recording's queries. For triangles, this project builds its own
/// hierarchies, each once; for objects, see object_contacts.
class OwnContacts {
  public:
    using Meshes = std::array<std::shared_ptr<const Mesh>, 2>;

    /// The exact answer of a query. Empty if a side has neither triangles nor objects, or a pose is
    /// unusable. `meshes`: the finite meshes of the query's bodies.
    QueryTruth truth(const EngineQuery& query, const Meshes& meshes);

  private:
    /// Keeps the mesh, so that a new mesh cannot get the address of a known one.
    struct Built {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const Hierarchy<Obb>> hierarchy;
    };

    QueryTruth nearest(const EngineQuery& query, const Meshes& meshes);
    std::shared_ptr<const Hierarchy<Obb>> hierarchy_of(const std::shared_ptr<const Mesh>& mesh);

    std::map<const Mesh*, Built> built_;  ///< lookups, and forgetting
    std::size_t forget_at_ = 16;          ///< at this size, meshes used nowhere else are dropped
};

}  // namespace scb::scenes
