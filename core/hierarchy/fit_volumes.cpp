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
              int threads, const FitTarget<V>& target) {
    BottomUpFit<V> fit(topology, points, options, threads, target);
    fit.run(0);
    if (options.counts != nullptr) options.counts->add(fit.counts());
}

// A name for each type, needed for the table of targets.
#define SCB_FIT_TREE(V)                                                                     \
    void fit_tree_##V(const Topology& topology, const LeafOrder& points,                    \
                      const FitOptions& options, int threads, const FitTarget<V>& target) { \
        fit_tree(topology, points, options, threads, target);                               \
    }
SCB_FOR_EACH_VOLUME(SCB_FIT_TREE)
#undef SCB_FIT_TREE

}  // namespace HWY_NAMESPACE
}  // namespace scb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scb {
namespace {

#define SCB_FIT_AT_LEVEL(V)                                                                   \
    HWY_EXPORT(fit_tree_##V);                                                                 \
    void fit_at_level(const Topology& topology, const LeafOrder& points,                      \
                      const FitOptions& options, int threads, const FitTarget<V>& target) {   \
        SCB_AT_LEVEL(fit_tree_##V, options.simd)(topology, points, options, threads, target); \
    }
SCB_FOR_EACH_VOLUME(SCB_FIT_AT_LEVEL)
#undef SCB_FIT_AT_LEVEL

}  // namespace

template <Volume V>
std::vector<V> fit_volumes(const Topology& topology, const LeafOrder& points,
                           const FitOptions& options, int threads, const FittedNodes& wanted) {
    std::vector<V> volumes;
    resize_large(volumes, topology.nodes.size());
    fit_at_level(topology, points, options, threads, FitTarget<V>{volumes, wanted.deepest});
    return volumes;
}

template <class V>
std::vector<V> fit_some(const Topology& topology, const LeafOrder& points,
                        const FitOptions& options, int threads,
                        const std::vector<std::uint32_t>& place, std::size_t count) {
    std::vector<V> volumes;
    resize_large(volumes, count);
    FitTarget<V> target{volumes};
    target.place = place;
    fit_at_level(topology, points, options, threads, target);
    return volumes;
}

#define SCB_INSTANTIATE(V)                                                                      \
    template std::vector<V> fit_some(const Topology&, const LeafOrder&, const FitOptions&, int, \
                                     const std::vector<std::uint32_t>&, std::size_t);
SCB_INSTANTIATE(Scb)
SCB_INSTANTIATE(Scb2)
#undef SCB_INSTANTIATE

#define SCB_INSTANTIATE(V)                                                                         \
    template std::vector<V> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int, \
                                        const FittedNodes&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
#endif
