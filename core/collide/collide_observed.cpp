#include "core/collide/dual_traversal.h"

// The second translation unit of collide.h: with somebody to tell.
namespace scb {
namespace {

struct Caller {
    const ObserverCalls& calls;

    void volume_test(IndexPair nodes, int depth_a, int depth_b, Stage stage) {
        calls.volume_test(calls.observer, nodes, depth_a, depth_b, stage);
    }
    void triangle_test(IndexPair triangles, bool intersect) {
        calls.triangle_test(calls.observer, triangles, intersect);
    }
};

}  // namespace

template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, EventRecorder& recorder) {
    return dual_traversal(a, b, b_to_a, options, recorder);
}

template <Volume V>
Collision collide(const Collider<V>& a, const Collider<V>& b, const Pose& b_to_a,
                  const CollideOptions& options, const ObserverCalls& calls) {
    Caller caller{calls};
    return dual_traversal(a, b, b_to_a, options, caller);
}

#define SCB_INSTANTIATE(V)                                                          \
    template Collision collide(const Collider<V>&, const Collider<V>&, const Pose&, \
                               const CollideOptions&, EventRecorder&);              \
    template Collision collide(const Collider<V>&, const Collider<V>&, const Pose&, \
                               const CollideOptions&, const ObserverCalls&);
SCB_FOR_EACH_VOLUME(SCB_INSTANTIATE)
#undef SCB_INSTANTIATE

}  // namespace scb
