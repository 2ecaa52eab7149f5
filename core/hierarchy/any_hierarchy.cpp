#include "scb/any_hierarchy.h"

#include <array>
#include <utility>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"

namespace scb {
namespace {

#define SCB_KIND(kind, V, name) VolumeKind::kind,
constexpr std::array all_kinds = {SCB_FOR_EACH_VOLUME_KIND(SCB_KIND)};
#undef SCB_KIND
#define SCB_NAME(kind, V, name) std::string_view(name),
constexpr std::array kind_names = {SCB_FOR_EACH_VOLUME_KIND(SCB_NAME)};
#undef SCB_NAME

}  // namespace

std::string_view volume_kind_name(VolumeKind kind) {
    return kind_names[static_cast<std::size_t>(kind)];
}
std::optional<VolumeKind> volume_kind_of(std::string_view name) {
    for (const VolumeKind kind : all_kinds)
        if (volume_kind_name(kind) == name) return kind;
    return std::nullopt;
}

std::span<const VolumeKind> all_volume_kinds() { return all_kinds; }

bool has_growth(VolumeKind kind) { return has_margin(kind) || kind == VolumeKind::ball; }
bool has_margin(VolumeKind kind) { return kind == VolumeKind::scb || kind == VolumeKind::scb2; }

AnyHierarchy fit_any(VolumeKind kind, std::shared_ptr<const Topology> topology,
                     const LeafOrder& points, FitOptions options, int threads,
                     const FittedNodes& wanted) {
    if (kind == VolumeKind::ball) options.ball_method = BallMethod::minimum;
    if (kind == VolumeKind::ritter) options.ball_method = BallMethod::ritter;
    return with_volume_type(kind, [&]<Volume V>() -> AnyHierarchy {
        std::vector<V> volumes = fit_volumes<V>(*topology, points, options, threads, wanted);
        return Hierarchy<V>{std::move(topology), std::move(volumes)};
    });
}

std::vector<AnyHierarchy> build_hierarchies(const Mesh& mesh, std::span<const VolumeKind> kinds,
                                            const BuildOptions& options, std::string_view name) {
    const MeshTopology shared = checked_topology(mesh, options, name);
    std::vector<AnyHierarchy> hierarchies;
    for (const VolumeKind kind : kinds)
        hierarchies.push_back(
            fit_any(kind, shared.topology, shared.points, options.fit, options.threads));
    return hierarchies;
}

const Topology& topology_of(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) -> const Topology& { return *h.topology; }, hierarchy);
}

std::string validate(const AnyHierarchy& hierarchy, const Mesh& mesh) {
    return std::visit([&](const auto& h) { return validate(h, mesh); }, hierarchy);
}

std::size_t bytes_per_volume(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) { return sizeof(h.volumes[0]); }, hierarchy);
}

std::size_t bytes_of(const AnyHierarchy& hierarchy) {
    const Topology& topology = topology_of(hierarchy);
    return topology.nodes.size() * (sizeof(TopologyNode) + bytes_per_volume(hierarchy)) +
           topology.order.size() * sizeof(topology.order[0]);
}

}  // namespace scb
