#pragma once

#include "scb/any_hierarchy.h"
#include "scb/packed_collide.h"
#include "scb/packed_distance.h"
#include "scb/packed_layout.h"

namespace scb {

/// A packed hierarchy whose layout is chosen at run time.
using AnyPacked = AnyCodec<PackedHierarchy>;

/// Whether volumes of this kind can be packed: slab cut balls, with one slab or two.
bool can_pack(VolumeKind kind);

/// `pack` with this layout; V is Scb or Scb2. Throws InputError as `pack` does, if the width of the
/// layout is not 2, 4 or 8, and if the volumes cannot be packed.
template <class V>
AnyPacked pack_any(const PackedLayout& layout, const Hierarchy<V>& hierarchy, const Mesh& mesh,
                   std::string_view name = "mesh", int threads = 1);
/// The same for a hierarchy whose volume type was chosen at run time.
AnyPacked pack_any(const PackedLayout& layout, const AnyHierarchy& hierarchy, const Mesh& mesh,
                   std::string_view name = "mesh", int threads = 1);

/// `build_packed` with this layout. Throws InputError as `build_packed` does, if the width of the
/// layout is not 2, 4 or 8, and if volumes of this kind cannot be packed.
AnyPacked build_packed_any(const PackedLayout& layout, VolumeKind kind, const Mesh& mesh,
                           const BuildOptions& options = packed_build,
                           std::string_view name = "mesh");

/// `collide_packed` for hierarchies of one layout. Throws InputError where A and B have different
/// layouts or volumes.
PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a,
                               const PackedOptions& options = {},
                               PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

/// `collide_packed` with an observer, for hierarchies of one layout. Throws InputError where A and
/// B have different layouts or volumes.
PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a, const PackedOptions& options,
                               const ObserverCalls& calls);

/// `touches` for hierarchies of one layout. Throws InputError where A and B have different layouts
/// or volumes.
PackedTouch touches(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b, const Mesh& mesh_b,
                    const Pose& b_to_a, const PackedOptions& options = {},
                    PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

/// `distance_packed` for hierarchies of one layout. Throws InputError where A and B have different
/// layouts or volumes.
PackedDistance distance_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a,
                               const DistanceOptions& options = {},
                               SimdLevel level = SimdLevel::best);

/// `within_packed` for hierarchies of one layout. Throws InputError where A and B have different
/// layouts or volumes.
PackedWithin within_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                           const Mesh& mesh_b, const Pose& b_to_a, double tolerance,
                           SimdLevel level = SimdLevel::best);

/// Hierarchies of a known layout would be copied into AnyPacked: give PackedColliders instead.
template <class Codec, class... Rest>
PackedCollision collide_packed(const PackedHierarchy<Codec>& a, const Rest&...) = delete;
/// The same.
template <class Codec, class... Rest>
PackedTouch touches(const PackedHierarchy<Codec>& a, const Rest&...) = delete;
/// The same.
template <class Codec, class... Rest>
PackedDistance distance_packed(const PackedHierarchy<Codec>& a, const Rest&...) = delete;
/// The same.
template <class Codec, class... Rest>
PackedWithin within_packed(const PackedHierarchy<Codec>& a, const Rest&...) = delete;

/// `validate` for any layout.
std::string validate(const AnyPacked& packed, const Mesh& mesh);
/// The memory of its nodes and leaves, in bytes.
std::size_t bytes_of(const AnyPacked& packed);

}  // namespace scb
