#pragma once

#include "scb/any_hierarchy.h"
#include "scb/distance.h"

namespace scb {

/// `distance` for hierarchies whose volume type was chosen at run time. Throws InputError where A
/// and B hold different types of volumes.
Distance distance(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const DistanceOptions& options = {});

/// The same, with every test recorded.
Distance distance(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const DistanceOptions& options,
                  StepRecorder& recorder);

/// `within` for hierarchies whose volume type was chosen at run time. Throws InputError likewise.
Collision within(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                 const Mesh& mesh_b, const Pose& b_to_a, double tolerance,
                 DescentRule descent = DescentRule::radius);

/// The same, with every test recorded.
Collision within(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                 const Mesh& mesh_b, const Pose& b_to_a, double tolerance, DescentRule descent,
                 StepRecorder& recorder);

/// The stages of these queries on volumes of this kind: the directions along which the largest
/// bound may have been.
std::span<const Stage> distance_stages(VolumeKind kind);

}  // namespace scb
