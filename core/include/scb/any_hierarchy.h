#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "scb/hierarchy.h"

namespace scb {

/// The volumes that can be asked for by name.
enum class VolumeKind { scb, ball, ritter, obb, scb2, aabb, aabb_exact };

/// How a kind is named on the command line and in file names: "scb", "ball", "ritter", "obb",
/// "scb2", "aabb", "aabb-exact".
std::string_view volume_kind_name(VolumeKind kind);
std::optional<VolumeKind> volume_kind_of(std::string_view name);
std::span<const VolumeKind> all_volume_kinds();

/// Whether FitOptions::growth and FitOptions::margin mean anything to the kind.
bool has_growth(VolumeKind kind);
bool has_margin(VolumeKind kind);

/// A hierarchy whose volume type is chosen at run time. This is the edge: everything below it is a
/// template.
using AnyHierarchy = std::variant<Hierarchy<Scb>, Hierarchy<Ball>, Hierarchy<Obb>, Hierarchy<Scb2>,
                                  Hierarchy<Aabb>, Hierarchy<ExactAabb>>;

/// Calls `use<V>()` with the type of the kind's volumes, and returns what it returns.
template <class Use>
decltype(auto) with_volume_type(VolumeKind kind, Use&& use) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return use.template operator()<Ball>();
        case VolumeKind::obb:
            return use.template operator()<Obb>();
        case VolumeKind::scb2:
            return use.template operator()<Scb2>();
        case VolumeKind::aabb:
            return use.template operator()<Aabb>();
        case VolumeKind::aabb_exact:
            return use.template operator()<ExactAabb>();
    }
    return use.template operator()<Scb>();
}

/// A hierarchy of each kind, all on one topology, so that a difference between two of them comes
/// from their volumes alone. Throws as build_hierarchy does.
std::vector<AnyHierarchy> build_hierarchies(const Mesh& mesh, std::span<const VolumeKind> kinds,
                                            const BuildOptions& options = {},
                                            std::string_view name = "mesh");

const Topology& topology_of(const AnyHierarchy& hierarchy);
std::string validate(const AnyHierarchy& hierarchy, const Mesh& mesh);

/// sizeof the volume of one node.
std::size_t bytes_per_volume(const AnyHierarchy& hierarchy);

/// Its nodes, their volumes, and the order of the triangles; without the mesh.
std::size_t bytes_of(const AnyHierarchy& hierarchy);

}  // namespace scb
