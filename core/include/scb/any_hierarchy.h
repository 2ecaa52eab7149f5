#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "core/hierarchy/level_statistics.h"
#include "scb/hierarchy.h"

namespace scb {

/// The volumes that can be asked for by name.
enum class VolumeKind { scb, ball, ritter, obb };

/// How a kind is named on the command line and in file names: "scb", "ball", "ritter", "obb".
std::string_view volume_kind_name(VolumeKind kind);
std::optional<VolumeKind> volume_kind_of(std::string_view name);
std::span<const VolumeKind> all_volume_kinds();

/// A hierarchy whose volume type is chosen at run time. This is the edge: everything below it is a
/// template.
using AnyHierarchy = std::variant<Hierarchy<Scb>, Hierarchy<Ball>, Hierarchy<Obb>>;

/// Fits volumes of the kind to a topology; `ritter` sets FitOptions::ball_method.
AnyHierarchy fit_any(VolumeKind kind, std::shared_ptr<const Topology> topology,
                     const LeafOrder& points, FitOptions options = {}, int threads = 1);

const Topology& topology_of(const AnyHierarchy& hierarchy);
std::string validate(const AnyHierarchy& hierarchy, const Mesh& mesh);
std::vector<LevelStatistics> level_statistics(const AnyHierarchy& hierarchy);

/// sizeof the volume of one node.
std::size_t bytes_per_volume(const AnyHierarchy& hierarchy);

}  // namespace scb
