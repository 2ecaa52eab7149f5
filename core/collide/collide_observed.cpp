#include "core/collide/dual_traversal.h"

// The second translation unit of collide.h: with an observer.
namespace scb {
template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, StepRecorder& recorder) {
    return dual_traversal(a, b, b_to_a, options, recorder);
}

template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, const ObserverCalls& calls) {
    CalledObserver caller{calls};
    return dual_traversal(a, b, b_to_a, options, caller);
}

template <Volume V>
Collision collide_self(const SelfCollider<V>& side, const CollideOptions& options,
                       StepRecorder& recorder) {
    const Collider<V> both{side.hierarchy, side.mesh};
    return dual_traversal(both, both, Pose{}, options, recorder, side.joined);
}

template <Volume V>
Collision collide_self(const SelfCollider<V>& side, const CollideOptions& options,
                       const ObserverCalls& calls) {
    CalledObserver caller{calls};
    const Collider<V> both{side.hierarchy, side.mesh};
    return dual_traversal(both, both, Pose{}, options, caller, side.joined);
}

#define SCB_INSTANTIATE(V)                                                                         \
    template Collision collide(const Collider<V>&, const Collider<V>&, const Pose&,                \
                               const CollideOptions&, StepRecorder&);                              \
    template Collision collide(const Collider<V>&, const Collider<V>&, const Pose&,                \
                               const CollideOptions&, const ObserverCalls&);                       \
    template Collision collide_self(const SelfCollider<V>&, const CollideOptions&, StepRecorder&); \
    template Collision collide_self(const SelfCollider<V>&, const CollideOptions&,                 \
                                    const ObserverCalls&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
