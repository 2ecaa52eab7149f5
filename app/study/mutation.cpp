#include "app/study/mutation.h"

#include <algorithm>
#include <utility>

namespace scb::app {
namespace {

void grow(Scb& volume, double by) { volume.r *= by; }
void grow(Scb2& volume, double by) { volume.r *= by; }
void grow(Ball& volume, double by) { volume.radius *= by; }
void grow(Obb& volume, double by) { volume.half *= by; }
template <bool exact>
void grow(BasicAabb<exact>& volume, double by) {
    volume.half *= by;
}

/// The first node at that depth, or the last one.
std::size_t node_at(const Topology& topology, int depth) {
    const std::vector<std::uint16_t> depths = node_depths(topology);
    const auto at = std::find(depths.begin(), depths.end(), depth);
    return at == depths.end() ? depths.size() - 1 : static_cast<std::size_t>(at - depths.begin());
}

}  // namespace

void mutate(Mutation mutation, AnyHierarchy& hierarchy) {
    if (mutation != Mutation::drop_node && mutation != Mutation::nudge_radius) return;
    std::visit(
        [mutation]<class V>(Hierarchy<V>& of) {
            const bool drops = mutation == Mutation::drop_node;
            V& volume = of.volumes[node_at(*of.topology, drops ? 7 : 5)];
            // Convex volumes cannot be scaled: replace the volume.
            if constexpr (ConvexVolume<V>)
                volume = drops ? V{} : of.volumes[0];
            else
                grow(volume, drops ? 0 : 1.001);
        },
        hierarchy);
}

void mutate(Mutation mutation, OverlapOptions& options) {
    if (mutation == Mutation::flip_comparison && options.test == OverlapTest::symmetric)
        options.test = OverlapTest::printed;
}

void mutate(Mutation mutation, Collision& found, VolumeKind kind, const OverlapOptions& options) {
    if (mutation != Mutation::swap_stages) return;
    std::swap(found.stages[static_cast<std::size_t>(Stage::slab_ball)],
              found.stages[static_cast<std::size_t>(Stage::ball_slab)]);
    found.n_u = transform_count(kind, found.stages, options);
}

void mutate(Mutation mutation, Steps& steps) {
    if (mutation != Mutation::swap_stages) return;
    for (Step& test : steps.volumes) {
        if (test.stage == Stage::slab_ball)
            test.stage = Stage::ball_slab;
        else if (test.stage == Stage::ball_slab)
            test.stage = Stage::slab_ball;
    }
}

}  // namespace scb::app
