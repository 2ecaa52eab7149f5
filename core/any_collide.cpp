#include "core/any_collide.h"

#include <cassert>

namespace scb {
namespace {

template <class Observer>
Collision collide_with(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                       const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options,
                       Observer& observer) {
    assert(a.index() == b.index() && "both hierarchies must have the same volumes");
    return std::visit(
        [&]<class V>(const Hierarchy<V>& hierarchy_a) {
            return collide(Collider<V>{hierarchy_a, mesh_a},
                           Collider<V>{std::get<Hierarchy<V>>(b), mesh_b}, b_to_a, options,
                           observer);
        },
        a);
}

}  // namespace

Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options) {
    NoObserver none;
    return collide_with(a, mesh_a, b, mesh_b, b_to_a, options, none);
}

Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options,
                  EventRecorder& recorder) {
    return collide_with(a, mesh_a, b, mesh_b, b_to_a, options, recorder);
}

std::span<const Stage> stages_of(const AnyHierarchy& hierarchy, const OverlapOptions& options) {
    if (std::holds_alternative<Hierarchy<Ball>>(hierarchy)) return ball_stages();
    if (std::holds_alternative<Hierarchy<Obb>>(hierarchy)) return obb_stages();
    return stages_of(options.test);
}

}  // namespace scb
