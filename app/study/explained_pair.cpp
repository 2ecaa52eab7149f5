#include "app/study/explained_pair.h"

#include "app/report/build_text.h"
#include "core/collide/query_placement.h"
#include "core/volumes/shape.h"

#include <cmath>

#include "scb/error.h"

namespace scb::app {
namespace {

template <class V>
constexpr VolumeKind raw_kind = VolumeKind::scb;
template <>
constexpr VolumeKind raw_kind<Scb2> = VolumeKind::scb2;
template <>
constexpr VolumeKind raw_kind<Ball> = VolumeKind::ball;
template <>
constexpr VolumeKind raw_kind<Obb> = VolumeKind::obb;

}  // namespace

ExplainedNode explained_node(const AnyHierarchy& hierarchy, const std::string& body,
                             std::int64_t node, const std::string& option) {
    const Topology& topology = topology_of(hierarchy);
    if (node < 0 || node >= static_cast<std::int64_t>(topology.nodes.size()))
        throw InputError(option + ": there is no node " + std::to_string(node) + " of " + body +
                         "; its hierarchy has the nodes 0 to " +
                         std::to_string(topology.nodes.size() - 1) + ".");
    const auto index = static_cast<std::uint32_t>(node);
    return {body, index, node_depth(topology, index), topology.nodes[index].count};
}

ExplainedPair explained_nodes(VolumeKind kind, const AnyHierarchy& a, const AnyHierarchy& b,
                              const Pose& b_to_a, const OverlapOptions& options,
                              const BuildOptions& build,
                              const std::array<ExplainedNode, 2>& nodes) {
    return std::visit(
        [&]<class V>(const Hierarchy<V>& of_a) -> ExplainedPair {
            const auto& of_b = std::get<Hierarchy<V>>(b);
            const V &v = of_a.volumes[nodes[0].index], &w = of_b.volumes[nodes[1].index];
            const Placement placed = query_placement(of_a, of_b, b_to_a);
            std::vector<std::string> notes;
            if (const std::string built = build_sentence(build); !built.empty())
                notes.push_back(built);
            return {kind,   shape_of(v), shape_of(w),
                    placed, options,     explain(v, w, placed, options),
                    notes,  nodes};
        },
        a);
}

ExplainedPair explained_nodes(const SceneQuery& query, int frame,
                              const std::array<std::int64_t, 2>& nodes, const std::string& option) {
    const AnyHierarchy &a = query.hierarchy(query.a), &b = query.hierarchy(query.b);
    const std::vector<scenes::Body>& bodies = query.scene.bodies;
    return explained_nodes(query.kind, a, b, query.b_to_a(frame), query.options.overlap,
                           query.build,
                           {explained_node(a, bodies[query.a].name, nodes[0], option),
                            explained_node(b, bodies[query.b].name, nodes[1], option)});
}

ExplainedPair explained_volumes(const scenes::AnyRawPair& pair, const OverlapOptions& options) {
    return std::visit(
        [&]<class V>(const scenes::RawPair<V>& p) -> ExplainedPair {
            const Placement placed = placement(p.b_to_a, reach(p.a), reach(p.b));
            return {raw_kind<V>, p.a, p.b, placed, options, explain(p.a, p.b, placed, options),
                    p.notes};
        },
        pair);
}

AnyVolume b_seen_from_a(const ExplainedPair& pair) {
    return std::visit([&](const auto& b) { return AnyVolume(seen_from_a(b, pair.placed)); },
                      pair.b);
}

double normal_angle(const ExplainedPair& pair) {
    constexpr double degrees_per_radian = 57.29577951308232;
    const Vec3 a = std::get<Scb>(pair.a).n, b = std::get<Scb>(b_seen_from_a(pair)).n;
    // atan2 is accurate for small angles.
    const double degrees =
        std::atan2(std::sqrt(squared_norm(cross(a, b))), dot(a, b)) * degrees_per_radian;
    return std::round(degrees * 1e9) / 1e9;
}

}  // namespace scb::app
