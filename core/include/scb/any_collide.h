#pragma once

#include "scb/any_hierarchy.h"
#include "scb/collide.h"
#include "scb/event_recorder.h"

namespace scb {

/// `collide` for hierarchies whose volume type was chosen at run time. Throws
/// InputError where theirs are two.
Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options = {});

/// The same, with every test recorded.
Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options,
                  EventRecorder& recorder);

/// The stages at which a query on these volumes can reject.
std::span<const Stage> stages_of(VolumeKind kind, const OverlapOptions& options);

/// transform_count for a kind of volume.
std::uint64_t transform_count(VolumeKind kind, const StageCounts& stages,
                              const OverlapOptions& options);

}  // namespace scb
