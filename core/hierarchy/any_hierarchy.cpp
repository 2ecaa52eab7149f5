#include "scb/any_hierarchy.h"

#include <array>
#include <utility>

namespace scb {
namespace {

constexpr std::array kinds = {VolumeKind::scb, VolumeKind::ball, VolumeKind::ritter,
                              VolumeKind::obb};
constexpr std::array<std::string_view, kinds.size()> names = {"scb", "ball", "ritter", "obb"};

}  // namespace

std::string_view volume_kind_name(VolumeKind kind) { return names[static_cast<std::size_t>(kind)]; }

std::optional<VolumeKind> volume_kind_of(std::string_view name) {
    for (const VolumeKind kind : kinds)
        if (volume_kind_name(kind) == name) return kind;
    return std::nullopt;
}

std::span<const VolumeKind> all_volume_kinds() { return kinds; }

AnyHierarchy fit_any(VolumeKind kind, std::shared_ptr<const Topology> topology,
                     const LeafOrder& points, FitOptions options, int threads) {
    const auto fitted = [&]<class V>(V) -> AnyHierarchy {
        std::vector<V> volumes = fit_volumes<V>(*topology, points, options, threads);
        return Hierarchy<V>{std::move(topology), std::move(volumes)};
    };
    switch (kind) {
        case VolumeKind::ball:
            options.ball_method = BallMethod::minimum;
            return fitted(Ball{});
        case VolumeKind::ritter:
            options.ball_method = BallMethod::ritter;
            return fitted(Ball{});
        case VolumeKind::obb:
            return fitted(Obb{});
        case VolumeKind::scb:
            break;
    }
    return fitted(Scb{});
}

const Topology& topology_of(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) -> const Topology& { return *h.topology; }, hierarchy);
}

std::string validate(const AnyHierarchy& hierarchy, const Mesh& mesh) {
    return std::visit([&](const auto& h) { return validate(h, mesh); }, hierarchy);
}

std::vector<LevelStatistics> level_statistics(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) { return level_statistics(h); }, hierarchy);
}

std::size_t bytes_per_volume(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) { return sizeof(h.volumes[0]); }, hierarchy);
}

}  // namespace scb
