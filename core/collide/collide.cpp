#include "scb/collide.h"

#include "core/collide/dual_traversal.h"

namespace scb {

template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options) {
    NoObserver none;
    return dual_traversal(a, b, b_to_a, options, none);
}

template <Volume V>
Collision collide_self(const SelfCollider<V>& side, const CollideOptions& options) {
    NoObserver none;
    const Collider<V> both{side.hierarchy, side.mesh};
    return dual_traversal(both, both, Pose{}, options, none, side.joined);
}

#define SCB_INSTANTIATE(V)                                                          \
    template Collision collide(const Collider<V>&, const Collider<V>&, const Pose&, \
                               const CollideOptions&);                              \
    template Collision collide_self(const SelfCollider<V>&, const CollideOptions&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
