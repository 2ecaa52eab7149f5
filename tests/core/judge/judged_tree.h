#pragma once

#include "core/judge/engine_query.h"

namespace scb {

/// Four triangles in a row along x, one per unit.
inline Mesh row_of_triangles() {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 4; ++i) {
        for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0, 0.5, 0)})
            mesh.vertices.emplace_back(corner + Vec3(i, 0, 0));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

/// A box about the triangles from `first` to `last`.
inline Obb box_of_row(double first, double last) {
    return {Vec3((first + last + 0.5) / 2, 0.25, 0), Mat3::Identity(),
            Vec3((last + 0.5 - first) / 2, 0.25, 0)};
}

struct ToldNode {
    std::uint32_t number = 0, parent = no_index;
    std::vector<std::uint32_t> children, items;
    NodeVolume volume;
};

/// 0 holds 1 and 2, which hold 3 to 6, which hold a triangle each.
inline std::vector<ToldNode> nodes_of_row() {
    return {{0, no_index, {1, 2}, {}, box_of_row(0, 3)},
            {1, 0, {3, 4}, {}, box_of_row(0, 1)},
            {2, 0, {5, 6}, {}, box_of_row(2, 3)},
            {3, 1, {}, {0}, box_of_row(0, 0)},
            {4, 1, {}, {1}, box_of_row(1, 1)},
            {5, 2, {}, {2}, box_of_row(2, 2)},
            {6, 2, {}, {3}, box_of_row(3, 3)}};
}

inline EngineNodes tree_of(const std::vector<ToldNode>& nodes) {
    EngineNodes tree;
    for (const ToldNode& told : nodes) {
        EngineNode node;
        node.number = told.number;
        node.parent = told.parent;
        node.volume = told.volume;
        tree.add(node, "", told.children, told.items);
    }
    return tree;
}

}  // namespace scb
