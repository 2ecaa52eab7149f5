#include "scb/any_distance.h"

#include <array>

#include "core/distance/volume_gap.h"
#include "core/hierarchy/same_volumes.h"

namespace scb {

Distance distance(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const DistanceOptions& options) {
    return with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        return distance(Collider<V>{of_a, mesh_a}, Collider<V>{of_b, mesh_b}, b_to_a, options);
    });
}

Collision within(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                 const Mesh& mesh_b, const Pose& b_to_a, double tolerance, DescentRule descent) {
    return with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        return within(Collider<V>{of_a, mesh_a}, Collider<V>{of_b, mesh_b}, b_to_a, tolerance,
                      descent);
    });
}

Distance distance(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const DistanceOptions& options,
                  StepRecorder& recorder) {
    return with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        return distance(Collider<V>{of_a, mesh_a}, Collider<V>{of_b, mesh_b}, b_to_a, options,
                        recorder);
    });
}

Collision within(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                 const Mesh& mesh_b, const Pose& b_to_a, double tolerance, DescentRule descent,
                 StepRecorder& recorder) {
    return with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        return within(Collider<V>{of_a, mesh_a}, Collider<V>{of_b, mesh_b}, b_to_a, tolerance,
                      descent, recorder);
    });
}

std::span<const Stage> distance_stages(VolumeKind kind) {
    static constexpr std::array stages = {Stage::center_line, Stage::slab_a, Stage::slab_b,
                                          Stage::long_axes};
    const std::span<const Stage> all = stages;
    return with_volume_type(kind, [all]<Volume V>() {
        return all.first(std::same_as<V, Ball> ? 1 : has_long_direction<V> ? 4 : 3);
    });
}

}  // namespace scb
