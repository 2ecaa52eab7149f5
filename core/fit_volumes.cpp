#include "core/hierarchy.h"
#include "core/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fit_volumes.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/bottom_up_fit-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

template <class V>
void fit_tree(const Topology& topology, const LeafOrder& points, const BuildOptions& options,
              std::span<V> volumes) {
    BottomUpFit<V> fit(topology, points, options, volumes);
    fit.run(0);
    if (options.fit.counts != nullptr) options.fit.counts->add(fit.counts());
}

void fit_scb_tree(const Topology& topology, const LeafOrder& points, const BuildOptions& options,
                  std::span<Scb> volumes) {
    fit_tree(topology, points, options, volumes);
}
void fit_ball_tree(const Topology& topology, const LeafOrder& points, const BuildOptions& options,
                   std::span<Ball> volumes) {
    fit_tree(topology, points, options, volumes);
}
void fit_obb_tree(const Topology& topology, const LeafOrder& points, const BuildOptions& options,
                  std::span<Obb> volumes) {
    fit_tree(topology, points, options, volumes);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {

HWY_EXPORT(fit_scb_tree);
HWY_EXPORT(fit_ball_tree);
HWY_EXPORT(fit_obb_tree);

template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const BuildOptions& options) {
    std::vector<V> volumes(topology.nodes.size());
    const std::span<V> all(volumes);
    if constexpr (std::is_same_v<V, Scb>)
        SCB_AT_LEVEL(fit_scb_tree, options.fit.simd)(topology, points, options, all);
    else if constexpr (std::is_same_v<V, Ball>)
        SCB_AT_LEVEL(fit_ball_tree, options.fit.simd)(topology, points, options, all);
    else if constexpr (std::is_same_v<V, Obb>)
        SCB_AT_LEVEL(fit_obb_tree, options.fit.simd)(topology, points, options, all);
    return volumes;
}

template std::vector<Scb> fit_volumes(const Topology&, const LeafOrder&, const BuildOptions&);
template std::vector<Ball> fit_volumes(const Topology&, const LeafOrder&, const BuildOptions&);
template std::vector<Obb> fit_volumes(const Topology&, const LeafOrder&, const BuildOptions&);

}  // namespace scb
#endif
