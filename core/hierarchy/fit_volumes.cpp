#include "core/hierarchy/fit_volumes.h"

#include "core/base/large_pages.h"
#include "core/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/hierarchy/fit_volumes.cpp"
#include <hwy/foreach_target.h>
// After the line above.
#include "core/hierarchy/bottom_up_fit-inl.h"

HWY_BEFORE_NAMESPACE();
namespace scb {
namespace HWY_NAMESPACE {

template <class V>
void fit_tree(const Topology& topology, const LeafOrder& points, const FitOptions& options,
              int threads, const FittedNodes& wanted, std::span<V> volumes) {
    BottomUpFit<V> fit(topology, points, options, threads, wanted, volumes);
    fit.run(0);
    if (options.counts != nullptr) options.counts->add(fit.counts());
}

void fit_scb_tree(const Topology& topology, const LeafOrder& points, const FitOptions& options,
                  int threads, const FittedNodes& wanted, std::span<Scb> volumes) {
    fit_tree(topology, points, options, threads, wanted, volumes);
}
void fit_scb2_tree(const Topology& topology, const LeafOrder& points, const FitOptions& options,
                   int threads, const FittedNodes& wanted, std::span<Scb2> volumes) {
    fit_tree(topology, points, options, threads, wanted, volumes);
}
void fit_ball_tree(const Topology& topology, const LeafOrder& points, const FitOptions& options,
                   int threads, const FittedNodes& wanted, std::span<Ball> volumes) {
    fit_tree(topology, points, options, threads, wanted, volumes);
}
void fit_obb_tree(const Topology& topology, const LeafOrder& points, const FitOptions& options,
                  int threads, const FittedNodes& wanted, std::span<Obb> volumes) {
    fit_tree(topology, points, options, threads, wanted, volumes);
}

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {

HWY_EXPORT(fit_scb_tree);
HWY_EXPORT(fit_scb2_tree);
HWY_EXPORT(fit_ball_tree);
HWY_EXPORT(fit_obb_tree);

template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options, int threads, const FittedNodes& wanted) {
    std::vector<V> volumes;
    resize_large(volumes, topology.nodes.size());
    const std::span<V> all(volumes);
    if constexpr (std::is_same_v<V, Scb>)
        SCB_AT_LEVEL(fit_scb_tree, options.simd)(topology, points, options, threads, wanted, all);
    else if constexpr (std::is_same_v<V, Scb2>)
        SCB_AT_LEVEL(fit_scb2_tree, options.simd)(topology, points, options, threads, wanted, all);
    else if constexpr (std::is_same_v<V, Ball>)
        SCB_AT_LEVEL(fit_ball_tree, options.simd)(topology, points, options, threads, wanted, all);
    else if constexpr (std::is_same_v<V, Obb>)
        SCB_AT_LEVEL(fit_obb_tree, options.simd)(topology, points, options, threads, wanted, all);
    return volumes;
}

template std::vector<Scb> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int,
                                      const FittedNodes&);
template std::vector<Scb2> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int,
                                       const FittedNodes&);
template std::vector<Ball> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int,
                                       const FittedNodes&);
template std::vector<Obb> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int,
                                      const FittedNodes&);

}  // namespace scb
#endif
