#include "scb/any_collide.h"

#include <array>

#include "core/base/enum_names.h"
#include "core/collide/dual_traversal.h"
#include "core/hierarchy/same_volumes.h"
#include "scb/collide.h"

namespace scb {

Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options) {
    return with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        return collide(Collider<V>{of_a, mesh_a}, Collider<V>{of_b, mesh_b}, b_to_a, options);
    });
}

Collision collide(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                  const Mesh& mesh_b, const Pose& b_to_a, const CollideOptions& options,
                  StepRecorder& recorder) {
    return with_both(a, b, [&]<class V>(const Hierarchy<V>& of_a, const Hierarchy<V>& of_b) {
        return collide(Collider<V>{of_a, mesh_a}, Collider<V>{of_b, mesh_b}, b_to_a, options,
                       recorder);
    });
}

Collision collide_self(const AnyHierarchy& side, const Mesh& mesh,
                       std::span<const std::uint32_t> joined, const CollideOptions& options) {
    return std::visit(
        [&]<class V>(const Hierarchy<V>& of) {
            return collide_self(SelfCollider<V>{of, mesh, joined}, options);
        },
        side);
}

Collision collide_self(const AnyHierarchy& side, const Mesh& mesh,
                       std::span<const std::uint32_t> joined, const CollideOptions& options,
                       StepRecorder& recorder) {
    return std::visit(
        [&]<class V>(const Hierarchy<V>& of) {
            return collide_self(SelfCollider<V>{of, mesh, joined}, options, recorder);
        },
        side);
}

std::span<const Stage> stages_of(VolumeKind kind, const OverlapOptions& options) {
    return with_volume_type(kind, [&]<Volume V>() -> std::span<const Stage> {
        if constexpr (ConvexVolume<V>) return convex_stages();
        if constexpr (std::same_as<V, Ball>) return ball_stages();
        if constexpr (std::same_as<V, Obb> || std::same_as<V, ExactAabb>) return obb_stages();
        if constexpr (std::same_as<V, Aabb>) return aabb_stages();
        if constexpr (std::same_as<V, Scb2>) return scb2_stages();
        return stages_of(options.test);
    });
}

std::uint64_t transform_count(VolumeKind kind, const StageCounts& stages,
                              const OverlapOptions& options) {
    return with_volume_type(kind, [&]<Volume V>() { return transform_count<V>(stages, options); });
}

namespace {

constexpr EnumNames<QueryKind, 4> kind_names = {"collide", "self", "distance", "within"};
constexpr std::array rules = {DescentRule::radius, DescentRule::area, DescentRule::volume,
                              DescentRule::alternating};
constexpr EnumNames<DescentRule, rules.size()> rule_names = {"radius", "area", "volume",
                                                             "alternating"};

}  // namespace

std::string_view query_kind_name(QueryKind kind) { return kind_names[kind]; }

std::string_view descent_rule_name(DescentRule rule) { return rule_names[rule]; }
std::optional<DescentRule> descent_rule_of(std::string_view name) { return rule_names.find(name); }

std::span<const DescentRule> all_descent_rules() { return rules; }

}  // namespace scb
