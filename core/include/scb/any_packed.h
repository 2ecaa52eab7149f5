#pragma once

#include "scb/packed_collide.h"
#include "scb/packed_layout.h"

namespace scb {

/// A packed hierarchy whose layout is chosen at run time, as AnyHierarchy's volumes are.
using AnyPacked = AnyCodec<PackedHierarchy>;

/// `pack` to a layout. Throws InputError as that does, and where the layout has another width than
/// 2, 4 or 8.
AnyPacked pack_any(const PackedLayout& layout, const Hierarchy<Scb>& hierarchy, const Mesh& mesh,
                   std::string_view name = "mesh", int threads = 1);

/// `build_packed` in a layout. Throws InputError as that does, and where the layout has another
/// width than 2, 4 or 8.
AnyPacked build_packed_any(const PackedLayout& layout, const Mesh& mesh,
                           const BuildOptions& options = {}, std::string_view name = "mesh");

/// `collide_packed` for hierarchies of one layout. Throws InputError where A and B have different
/// layouts.
PackedCollision collide_packed(const AnyPacked& a, const Mesh& mesh_a, const AnyPacked& b,
                               const Mesh& mesh_b, const Pose& b_to_a,
                               const PackedOptions& options = {},
                               PackedWorkspace* workspace = nullptr, PackedFront* front = nullptr);

/// `validate` for the layout that it has.
std::string validate(const AnyPacked& packed, const Mesh& mesh);
/// The memory that its nodes and leaves take.
std::size_t bytes_of(const AnyPacked& packed);

}  // namespace scb
