#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "scb/hierarchy.h"

namespace scb {

/// The volumes that can be asked for by name.
#define SCB_KIND(kind, V, name) kind,
enum class VolumeKind { SCB_FOR_EACH_VOLUME_KIND(SCB_KIND) };
#undef SCB_KIND

/// How a kind is named on the command line and in file names, see SCB_FOR_EACH_VOLUME_KIND.
std::string_view volume_kind_name(VolumeKind kind);
std::optional<VolumeKind> volume_kind_of(std::string_view name);
std::span<const VolumeKind> all_volume_kinds();

/// Whether FitOptions::growth and FitOptions::margin mean anything to the kind.
bool has_growth(VolumeKind kind);
bool has_margin(VolumeKind kind);

/// A hierarchy whose volume type is chosen at run time. This is the edge: everything below it is a
/// template.
template <class First, class... Volumes>
using VariantOfHierarchies = std::variant<Hierarchy<Volumes>...>;
#define SCB_THEN(V) , V
using AnyHierarchy = VariantOfHierarchies<void SCB_FOR_EACH_VOLUME(SCB_THEN)>;
#undef SCB_THEN

/// Calls `use<V>()` with the type of the kind's volumes, and returns what it returns.
template <class Use>
decltype(auto) with_volume_type(VolumeKind kind, Use&& use) {
    switch (kind) {
#define SCB_CASE(kind, V, name) \
    case VolumeKind::kind:      \
        return use.template operator()<V>();
        SCB_FOR_EACH_VOLUME_KIND(SCB_CASE)
#undef SCB_CASE
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
