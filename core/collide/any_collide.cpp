#include "scb/any_collide.h"

namespace scb {
namespace {

template <class Observer>
Collision collide_with(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                       const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options,
                       Observer& observer) {
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

std::span<const Stage> stages_of(VolumeKind kind, const OverlapOptions& options) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return ball_stages();
        case VolumeKind::obb:
            return obb_stages();
    }
    return stages_of(options.test);
}

std::uint64_t transform_count(VolumeKind kind, const StageCounts& stages,
                              const OverlapOptions& options) {
    switch (kind) {
        case VolumeKind::scb:
            break;
        case VolumeKind::ball:
        case VolumeKind::ritter:
            return transform_count<Ball>(stages, options);
        case VolumeKind::obb:
            return transform_count<Obb>(stages, options);
    }
    return transform_count<Scb>(stages, options);
}

}  // namespace scb
