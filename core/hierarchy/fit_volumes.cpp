#include "core/hierarchy/fit_volumes.h"

#include <algorithm>
#include <utility>

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
    if (target.packable != nullptr) target.packable->triangles = std::move(fit.triangles());
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
PackableVolumes<V> fit_for_packing(const Topology& topology, const LeafOrder& points,
                                   const FitOptions& options, int threads, int leaf_triangles) {
    PackableVolumes<V> result;
    resize_large(result.costs, topology.nodes.size());
    resize_large(result.inner, topology.nodes.size() / 2);
    FitTarget<V> target;
    target.packable = &result;
    target.leaf_triangles = static_cast<std::uint32_t>(leaf_triangles);
    fit_at_level(topology, points, options, threads, target);
    std::sort(result.triangles.begin(), result.triangles.end(),
              [](const auto& x, const auto& y) { return x.first < y.first; });
    return result;
}

template PackableVolumes<Scb> fit_for_packing(const Topology&, const LeafOrder&, const FitOptions&,
                                              int, int);
template PackableVolumes<Scb2> fit_for_packing(const Topology&, const LeafOrder&, const FitOptions&,
                                               int, int);

#define SCB_INSTANTIATE(V)                                                                         \
    template std::vector<V> fit_volumes(const Topology&, const LeafOrder&, const FitOptions&, int, \
                                        const FittedNodes&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
#endif
