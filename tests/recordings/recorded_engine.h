#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/peers/peer.h"
#define SCB_RECORD_ON
#include <scb_record.h>

namespace scb {

/// Makes a query of an engine of somebody else's, and records its tests and pairs: body 0 at `a`,
/// body 1 at `b`.
using RecordedQuery = std::function<void(const PeerPose& a, const PeerPose& b)>;

/// Has the engine build its trees of two meshes, and records them. The recorder and the meshes
/// live longer than what is returned.
using MakeEngine = RecordedQuery(scb_recorder& recorder, const PeerMesh& a, const PeerMesh& b);
MakeEngine record_fcl, record_fcl_distance, record_bullet, record_dbvt, record_embree, record_cgal;

/// A mesh with a body of the same number, and the start of its tree, whose nodes follow.
template <class Real = double>
void record_body(scb_recorder& recorder, std::uint32_t number, const PeerMesh& mesh) {
    std::vector<Real> vertices;
    for (const auto& vertex : mesh.vertices)
        for (const double x : vertex) vertices.push_back(static_cast<Real>(x));
    const char* name = number == 0 ? "A" : "B";
    scb_record_mesh(&recorder, number, name, vertices.data(), sizeof(Real), 0,
                    static_cast<std::uint32_t>(mesh.vertices.size()), mesh.triangles.data(), 4,
                    static_cast<std::uint32_t>(mesh.triangles.size()));
    scb_record_tree(&recorder, number, name, number, nullptr, 0);
    scb_record_body(&recorder, number, name, number);
}

/// A node of an engine that does not know parents.
inline void record_node(scb_recorder& recorder, std::uint32_t tree, std::uint32_t number,
                        const std::vector<std::uint32_t>& children,
                        const std::vector<std::uint32_t>& items, scb_record_kind kind,
                        const std::vector<double>& values) {
    scb_record_node_data node = {};
    node.parent = SCB_RECORD_NONE;
    node.id = number;
    node.children = children.data();
    node.child_count = static_cast<std::uint32_t>(children.size());
    node.items = items.data();
    node.item_count = static_cast<std::uint32_t>(items.size());
    node.volume = {kind, static_cast<std::uint32_t>(values.size()), values.data()};
    scb_record_node(&recorder, tree, number, &node);
}

/// The body of an engine that has no tree of it, and asks with each of its triangles: a root, and
/// below it triangle i as node i + 1.
inline void record_triangles_as_nodes(scb_recorder& recorder, std::uint32_t tree,
                                      const PeerMesh& mesh) {
    record_body(recorder, tree, mesh);
    std::vector<std::uint32_t> children;
    std::vector<double> box = {HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        std::vector<double> corners;
        for (const std::uint32_t vertex : mesh.triangles[i])
            for (std::size_t k = 0; k < 3; ++k) {
                const double x = mesh.vertices[vertex][k];
                corners.push_back(x);
                box[k] = std::min(box[k], x);
                box[3 + k] = std::max(box[3 + k], x);
            }
        record_node(recorder, tree, i + 1, {}, {i}, SCB_RECORD_HULL, corners);
        children.push_back(i + 1);
    }
    record_node(recorder, tree, 0, children, {}, SCB_RECORD_AABB, box);
}

}  // namespace scb
