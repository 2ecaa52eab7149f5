#pragma once

#include "scb/any_hierarchy.h"
#include "scb/collide.h"
#include "scb/step_recorder.h"

namespace scb {

/// `collide` for hierarchies whose volume type was chosen at run time. Throws InputError where A
/// and B hold different types of volumes.
Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options = {});

/// The same, with every test recorded.
Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options,
                  StepRecorder& recorder);

/// `collide_self` for a hierarchy whose volume type was chosen at run time; `joined` as in
/// SelfCollider.
Collision collide_self(const AnyHierarchy& side, const Mesh& mesh,
                       std::span<const std::uint32_t> joined, const CollideOptions& options = {});

/// The same, with every test recorded.
Collision collide_self(const AnyHierarchy& side, const Mesh& mesh,
                       std::span<const std::uint32_t> joined, const CollideOptions& options,
                       StepRecorder& recorder);

/// The stages at which a query on these volumes can reject.
std::span<const Stage> stages_of(VolumeKind kind, const OverlapOptions& options);

/// N_u of equation 1: the points and directions of B's volumes that these tests transformed. Slab
/// cut balls: the center, and the normal if the test gets that far. Balls: the center. Oriented
/// boxes: the center and three axes. Boxes along the body's axes: the center. Balls with two slabs:
/// the center, and both normals if the balls overlap.
std::uint64_t transform_count(VolumeKind kind, const StageCounts& stages,
                              const OverlapOptions& options);

}  // namespace scb
