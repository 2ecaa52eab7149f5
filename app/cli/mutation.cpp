#include "app/cli/mutation.h"

#include <algorithm>

namespace scb {
namespace {

constexpr Mutation mutations[] = {Mutation::drop_node, Mutation::nudge_radius,
                                  Mutation::flip_comparison, Mutation::swap_stages,
                                  Mutation::shift_color};

Mutation current = Mutation::none;

void grow(Scb& volume, double by) { volume.r *= by; }
void grow(Ball& volume, double by) { volume.radius *= by; }
void grow(Obb& volume, double by) { volume.half *= by; }

/// The first node at that depth, or the last one.
std::size_t node_at(const Topology& topology, int depth) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    const auto at = std::find(depths.begin(), depths.end(), depth);
    return at == depths.end() ? depths.size() - 1 : static_cast<std::size_t>(at - depths.begin());
}

}  // namespace

std::span<const Mutation> all_mutations() { return mutations; }

std::string_view mutation_name(Mutation mutation) {
    switch (mutation) {
        case Mutation::drop_node:
            return "drop-node";
        case Mutation::nudge_radius:
            return "nudge-radius";
        case Mutation::flip_comparison:
            return "flip-comparison";
        case Mutation::swap_stages:
            return "swap-stages";
        case Mutation::shift_color:
            return "shift-color";
        case Mutation::none:
            break;
    }
    return "none";
}

std::optional<Mutation> mutation_of(std::string_view name) {
    for (const Mutation mutation : mutations)
        if (mutation_name(mutation) == name) return mutation;
    return std::nullopt;
}

void set_mutation(Mutation mutation) { current = mutation; }

void mutate(AnyHierarchy& hierarchy) {
    if (current != Mutation::drop_node && current != Mutation::nudge_radius) return;
    std::visit(
        [](auto& of) {
            if (current == Mutation::drop_node)
                grow(of.volumes[node_at(*of.topology, 7)], 0);
            else
                grow(of.volumes[node_at(*of.topology, 5)], 1.001);
        },
        hierarchy);
}

void mutate(OverlapOptions& options) {
    if (current == Mutation::flip_comparison) options.mutant = TestMutant::flipped_comparison;
    if (current == Mutation::swap_stages) options.mutant = TestMutant::swapped_stages;
}

bool mutates_pictures() { return current == Mutation::shift_color; }

Picture mutated(Picture picture) {
    if (!mutates_pictures()) return picture;
    const auto shift = [](Rgba8& color) {
        color.g = static_cast<std::uint8_t>(color.g < 255 ? color.g + 1 : color.g - 1);
    };
    for (Pane& pane : picture.panes) {
        for (VolumeInstance& volume : pane.volumes) shift(volume.color);
        for (MeshDraw& mesh : pane.meshes) {
            shift(mesh.color);
            for (Rgba8& color : mesh.triangle_colors) shift(color);
        }
    }
    return picture;
}

}  // namespace scb
