#pragma once

#include "scb/any_hierarchy.h"
#include "scb/packed_collide.h"
#include "scb/packed_layout.h"

namespace scb {

/// A packed hierarchy whose layout is chosen at run time, as AnyHierarchy's volumes are.
using AnyPacked = AnyCodec<PackedHierarchy>;

/// Whether packed layouts have such volumes: slab cut balls, with one slab or two.
bool can_pack(VolumeKind kind);

/// `pack` to a layout; V is Scb or Scb2. Throws InputError as that does, where the layout has
/// another width than 2, 4 or 8, and where the hierarchy is of volumes that no layout has.
template <class V>
AnyPacked pack_any(const PackedLayout& layout, const Hierarchy<V>& hierarchy, const Mesh& mesh,
                   std::string_view name = "mesh", int threads = 1);
/// The same of a hierarchy whose volume type was chosen at run time.
AnyPacked pack_any(const PackedLayout& layout, const AnyHierarchy& hierarchy, const Mesh& mesh,
                   std::string_view name = "mesh", int threads = 1);

/// `build_packed` in a layout, of volumes that can be packed. Throws InputError as that does, where
/// the layout has another width than 2, 4 or 8, and where no layout has such volumes.
AnyPacked build_packed_any(const PackedLayout& layout, VolumeKind kind, const Mesh& mesh,
                           const BuildOptions& options = packed_build,
                           std::string_view name = "mesh");

/// `collide_packed` for hierarchies of one layout. Throws InputError where A and B have different
/// layouts or volumes.
PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a,
                               const PackedOptions& options = {},
                               PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

/// `validate` for the layout that it has.
std::string validate(const AnyPacked& packed, const Mesh& mesh);
/// The memory that its nodes and leaves take.
std::size_t bytes_of(const AnyPacked& packed);

}  // namespace scb
