#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "scb/hierarchy.h"

namespace scb {

#define SCB_KIND(kind, V, name) kind,
/// The volumes that a user can choose by name.
enum class VolumeKind { SCB_FOR_EACH_VOLUME_KIND(SCB_KIND) };
#undef SCB_KIND

/// The name of a kind on the command line and in file names, see SCB_FOR_EACH_VOLUME_KIND.
std::string_view volume_kind_name(VolumeKind kind);
/// The kind with this name; no value if no kind has the name.
std::optional<VolumeKind> volume_kind_of(std::string_view name);
/// All kinds, in the order of SCB_FOR_EACH_VOLUME_KIND.
std::span<const VolumeKind> all_volume_kinds();

/// Whether the kind uses FitOptions::growth.
bool has_growth(VolumeKind kind);
/// Whether the kind uses FitOptions::margin.
bool has_margin(VolumeKind kind);

/// A hierarchy whose volume type is chosen at run time. Below this interface, everything is a
/// template.
template <class First, class... Volumes>
using VariantOfHierarchies = std::variant<Hierarchy<Volumes>...>;
#define SCB_THEN(V) , V
/// A hierarchy of one of the types of volume.h.
using AnyHierarchy = VariantOfHierarchies<void SCB_FOR_EACH_VOLUME(SCB_THEN)>;
#undef SCB_THEN

/// Calls `use<V>()` with the type of the kind's volumes, and returns its result.
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

/// The topology of a hierarchy with any volumes.
const Topology& topology_of(const AnyHierarchy& hierarchy);
/// `validate` for a hierarchy with any volumes.
std::string validate(const AnyHierarchy& hierarchy, const Mesh& mesh);

/// sizeof the volume of one node.
std::size_t bytes_per_volume(const AnyHierarchy& hierarchy);

/// The memory of its nodes, their volumes, and the order of the triangles, in bytes; without the
/// mesh.
std::size_t bytes_of(const AnyHierarchy& hierarchy);

}  // namespace scb
