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

// A name for each type, needed for the table of targets.
#define SCB_FIT_TREE(V)                                                                  \
    void fit_tree_##V(const Topology& topology, const LeafOrder& points,                 \
                      const FitOptions& options, int threads, const FittedNodes& wanted, \
                      std::span<V> volumes) {                                            \
        fit_tree(topology, points, options, threads, wanted, volumes);                   \
    }
SCB_FOR_EACH_VOLUME(SCB_FIT_TREE)
#undef SCB_FIT_TREE

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {
namespace {

#define SCB_FIT_AT_LEVEL(V)                                                              \
    HWY_EXPORT(fit_tree_##V);                                                            \
    void fit_at_level(const Topology& topology, const LeafOrder& points,                 \
                      const FitOptions& options, int threads, const FittedNodes& wanted, \
                      std::span<V> volumes) {                                            \
        SCB_AT_LEVEL(fit_tree_##V, options.simd)                                         \
        (topology, points, options, threads, wanted, volumes);                           \
    }
SCB_FOR_EACH_VOLUME(SCB_FIT_AT_LEVEL)
#undef SCB_FIT_AT_LEVEL

}  // namespace

template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options, int threads, const FittedNodes& wanted) {
    std::vector<V> volumes;
    resize_large(volumes, topology.nodes.size());
    fit_at_level(topology, points, options, threads, wanted, std::span<V>(volumes));
    return volumes;
}

#define SCB_INSTANTIATE(V)                                                                         \
    template std::vector<V> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int, \
                                        const FittedNodes&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
#endif
