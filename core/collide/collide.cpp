#include "scb/collide.h"

#include "core/collide/dual_traversal.h"

namespace scb {

template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options) {
    NoObserver none;
    return dual_traversal(a, b, b_to_a, options, none);
}

template Collision collide(const Collider<Scb>&, const Collider<Scb>&, const Pose&,
                           const CollideOptions&);
template Collision collide(const Collider<Scb2>&, const Collider<Scb2>&, const Pose&,
                           const CollideOptions&);
template Collision collide(const Collider<Ball>&, const Collider<Ball>&, const Pose&,
                           const CollideOptions&);
template Collision collide(const Collider<Obb>&, const Collider<Obb>&, const Pose&,
                           const CollideOptions&);

}  // namespace scb
