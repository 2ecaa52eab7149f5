#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#define SCB_RECORD_ON
#include <scb_record.h>

// The bodies of small engines, which the tests record.
namespace scb::small {

using Index = std::uint32_t;
using Vector = std::array<double, 3>;

/// Of [R|t].
struct Rows {
    double rows[12];
};

inline Vector place(const Rows& pose, const Vector& x) {
    Vector y{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double* row = pose.rows + 4 * i;
        y[i] = row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
    }
    return y;
}

/// A box, and the ball about it.
struct Volume {
    Vector center{}, half{};
    double radius = 0;
};

struct Node {
    std::vector<Index> children;
    Index triangle = SCB_RECORD_NONE, parent = SCB_RECORD_NONE;
    Volume volume;
};

/// A sheet of 2 n^2 triangles over a square, which waves, and its tree.
struct Sheet {
    static constexpr Index n = 8;
    std::vector<Vector> vertices{(n + 1) * (n + 1)};
    std::vector<std::array<Index, 3>> triangles;
    std::vector<Node> nodes;

    void wave(double phase) {
        for (Index j = 0; j <= n; ++j)
            for (Index i = 0; i <= n; ++i) {
                const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
                vertices[j * (n + 1) + i] = {x, y, phase * (x * x - y * y) + 0.25 * x * y};
            }
    }
    void build() {
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n; ++i) {
                const Index at = j * (n + 1) + i;
                triangles.push_back({at, at + 1, at + n + 2});
                triangles.push_back({at, at + n + 2, at + n + 1});
            }
        std::vector<Index> all;
        for (Index i = 0; i < triangles.size(); ++i) all.push_back(i);
        split(all, 0, SCB_RECORD_NONE);
    }
    /// Halves along x and y in turn; returns the node's number.
    Index split(std::vector<Index> below, std::size_t axis, Index parent) {
        const auto number = static_cast<Index>(nodes.size());
        nodes.emplace_back();
        nodes[number].parent = parent;
        if (below.size() == 1) {
            nodes[number].triangle = below[0];
            return number;
        }
        std::stable_sort(below.begin(), below.end(), [&](Index a, Index b) {
            return vertices[triangles[a][0]][axis] < vertices[triangles[b][0]][axis];
        });
        const auto middle = below.begin() + static_cast<std::ptrdiff_t>(below.size() / 2);
        for (const auto& part :
             {std::vector<Index>(below.begin(), middle), std::vector<Index>(middle, below.end())}) {
            const Index child = split(part, 1 - axis, number);
            nodes[number].children.push_back(child);
        }
        return number;
    }
    /// Returns the box of the triangles below a node. Updates the boxes of the node and of the
    /// nodes below it, except node `but`.
    std::array<Vector, 2> refit(Index number, Index but) {
        std::array<Vector, 2> ends = {Vector{1e9, 1e9, 1e9}, Vector{-1e9, -1e9, -1e9}};
        const auto add = [&](const Vector& lower, const Vector& upper) {
            for (std::size_t k = 0; k < 3; ++k) {
                ends[0][k] = std::min(ends[0][k], lower[k]);
                ends[1][k] = std::max(ends[1][k], upper[k]);
            }
        };
        for (const Index child : nodes[number].children) {
            const auto below = refit(child, but);
            add(below[0], below[1]);
        }
        if (nodes[number].triangle != SCB_RECORD_NONE)
            for (const Index corner : triangles[nodes[number].triangle])
                add(vertices[corner], vertices[corner]);
        if (number == but) return ends;
        Volume& volume = nodes[number].volume;
        double squared = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            volume.center[k] = (ends[0][k] + ends[1][k]) / 2;
            // So that the corners that are recorded contain what is between them.
            volume.half[k] = std::nextafter((ends[1][k] - ends[0][k]) / 2, 1e9);
            squared += volume.half[k] * volume.half[k];
        }
        volume.radius = std::sqrt(squared);
        return ends;
    }
};

/// Records the mesh of a sheet, as it is now.
inline void record_mesh(scb_recorder& recorder, Index number, const Sheet& sheet) {
    scb_record_mesh(&recorder, number, "sheet", sheet.vertices.data(), 8, 0,
                    static_cast<Index>(sheet.vertices.size()), sheet.triangles.data(), 4,
                    static_cast<Index>(sheet.triangles.size()));
}

/// Records a node with this volume or, if it was recorded before, its volume alone.
inline void record_node(scb_recorder& recorder, Index tree, Index number, const Node& node,
                        const scb_record_volume& volume, bool refit) {
    if (refit) return scb_record_refit(&recorder, tree, number, &volume);
    scb_record_node_data data = {};
    data.parent = node.parent;
    data.children = node.children.data();
    data.child_count = static_cast<Index>(node.children.size());
    data.items = &node.triangle;
    data.item_count = node.triangle != SCB_RECORD_NONE;
    data.volume = volume;
    scb_record_node(&recorder, tree, number, &data);
}

}  // namespace scb::small
