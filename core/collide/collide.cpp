#include "scb/collide.h"

#include "core/collide/dual_traversal.h"

namespace scb {

template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options) {
    NoObserver none;
    return dual_traversal(a, b, b_to_a, options, none);
}

#define SCB_INSTANTIATE(V)                                                          \
    template Collision collide(const Collider<V>&, const Collider<V>&, const Pose&, \
                               const CollideOptions&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
