#include "tests/recordings/small_engine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include "scb/triangle_overlap.h"
#define SCB_RECORD_ON
#include <scb_record.h>

namespace scb {
namespace {

using Index = std::uint32_t;
using Vector = std::array<double, 3>;

/// Of [R|t].
struct Rows {
    double rows[12];
};

Vector place(const Rows& pose, const Vector& x) {
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

/// Both bodies, and one traversal with an explicit stack.
struct Engine {
    static constexpr Index forgotten = 24;  ///< node of B
    Bug bug;
    scb_recorder recorder{};
    std::array<Sheet, 2> sheets;
    bool balls() const { return bug == Bug::wrong_radius; }

    void record_volume(Index tree, Index number, bool refit) {
        const Node& node = sheets[tree].nodes[number];
        const Volume& v = node.volume;
        double values[6] = {v.center[0], v.center[1], v.center[2], v.radius, 0, 0};
        for (std::size_t k = 0; !balls() && k < 3; ++k) {
            values[k] = v.center[k] - v.half[k];
            values[3 + k] = v.center[k] + v.half[k];
        }
        const scb_record_volume volume = {balls() ? SCB_RECORD_BALL : SCB_RECORD_AABB,
                                          balls() ? 4u : 6u, values};
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
    void record_mesh(Index number) {
        const Sheet& sheet = sheets[number];
        scb_record_mesh(&recorder, number, "sheet", sheet.vertices.data(), 8, 0,
                        static_cast<Index>(sheet.vertices.size()), sheet.triangles.data(), 4,
                        static_cast<Index>(sheet.triangles.size()));
    }
    void build(Index number) {
        Sheet& sheet = sheets[number];
        sheet.wave(0.5);
        sheet.build();
        if (bug == Bug::child_dropped && number == 0) sheet.nodes[91].children.pop_back();
        if (bug == Bug::wrong_triangle && number == 1)
            for (Node& node : sheet.nodes)
                if (node.triangle == 49) node.triangle = 48;
        sheet.refit(0, SCB_RECORD_NONE);
        record_mesh(number);
        scb_record_tree(&recorder, number, "sheet", number, nullptr, 0);
        for (Index i = 0; i < sheet.nodes.size(); ++i) record_volume(number, i, false);
        scb_record_body(&recorder, number, number == 0 ? "lower" : "upper", number);
    }
    /// The mesh of B waves on.
    void move(int frame) {
        Sheet& sheet = sheets[1];
        sheet.wave(0.5 - 0.25 * frame);
        const bool forgets = bug == Bug::box_not_refitted && frame == 2;
        sheet.refit(0, forgets ? forgotten : SCB_RECORD_NONE);
        record_mesh(1);
        for (Index i = 0; i < sheet.nodes.size(); ++i)
            if (!(forgets && i == forgotten)) record_volume(1, i, true);
    }

    /// 0 where they overlap, else the axis along which they do not, from 1 on.
    std::uint8_t axis_apart(const Volume& a, const Volume& b, const Rows& pose) const {
        const Vector center = place(pose, b.center);
        double squared = 0;
        std::uint8_t apart = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool flips = bug == Bug::axis_flipped && k == 1;
            const double distance =
                std::abs(flips ? center[k] + a.center[k] : center[k] - a.center[k]);
            squared += distance * distance;
            double reach = a.half[k] - (bug == Bug::margin_negative ? 0.02 : 0);
            for (std::size_t j = 0; j < 3; ++j) reach += std::abs(pose.rows[4 * k + j]) * b.half[j];
            if (apart == 0 && distance > reach) apart = static_cast<std::uint8_t>(k + 1);
        }
        const double radii = a.radius + (bug == Bug::wrong_radius ? a.radius : b.radius);
        return balls() ? squared > radii * radii : apart;
    }
    bool intersect(Index a, Index b, const Rows& pose) const;

    void query(const Rows& pose) {
        std::vector<std::array<Index, 2>> stack = {{0, 0}};
        std::vector<std::array<Index, 2>> pairs;
        std::size_t left = 0;
        while (stack.size() > left) {
            const auto [i, j] = stack.back();
            stack.pop_back();
            left = bug == Bug::early_exit;
            const Node &a = sheets[0].nodes[i], &b = sheets[1].nodes[j];
            const std::uint8_t apart = axis_apart(a.volume, b.volume, pose);
            scb_record_test(&recorder, i, j, apart);
            if (apart) continue;
            if (a.triangle != SCB_RECORD_NONE && b.triangle != SCB_RECORD_NONE) {
                const bool cut = intersect(a.triangle, b.triangle, pose);
                scb_record_items(&recorder, a.triangle, b.triangle, cut);
                if (cut) pairs.push_back({a.triangle, b.triangle});
                continue;
            }
            const bool divide_a =
                b.children.empty() || (!a.children.empty() && a.volume.radius > b.volume.radius);
            for (const Index child : divide_a ? a.children : b.children) {
                stack.push_back({divide_a ? child : i, divide_a ? j : child});
                if (bug == Bug::visited_twice && i == 2 && child == a.children[0] && divide_a)
                    stack.push_back(stack.back());
            }
        }
        for (const auto& [i, j] : pairs) scb_record_pair(&recorder, i, j);
    }
};

bool Engine::intersect(Index a, Index b, const Rows& pose) const {
    TriangleCorners corners_a, corners_b;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector& x = sheets[0].vertices[sheets[0].triangles[a][k]];
        const Vector y = place(pose, sheets[1].vertices[sheets[1].triangles[b][k]]);
        corners_a[k] = {x[0], x[1], x[2]};
        corners_b[k] = {y[0], y[1], y[2]};
    }
    return triangles_overlap(corners_a, corners_b);
}

/// B turns about z, and sinks a little.
Rows pose_at(int frame) {
    constexpr double sines[] = {0, 7.0 / 25, 3.0 / 5, 4.0 / 5},
                     cosines[] = {1, 24.0 / 25, 4.0 / 5, 3.0 / 5};
    const double s = sines[frame], c = cosines[frame];
    return {{c, -s, 0, 0.1 * frame, s, c, 0, 0.05, 0, 0, 1, 0.12 - 0.03 * frame}};
}

Rows transposed(Rows pose) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) std::swap(pose.rows[4 * i + j], pose.rows[4 * j + i]);
    return pose;
}

}  // namespace

void record_small_engine(Bug bug, const std::string& path) {
    Engine engine{bug, {}, {}};
    scb_record_open(&engine.recorder, path.c_str(), "a small engine");
    scb_record_setting(&engine.recorder, "results", "pairs");
    scb_record_stage(&engine.recorder, 1, engine.balls() ? "balls" : "x");
    if (!engine.balls()) {
        scb_record_stage(&engine.recorder, 2, "y");
        scb_record_stage(&engine.recorder, 3, "z");
    }
    for (const Index body : {0u, 1u}) engine.build(body);
    for (int frame = 0; frame < 4; ++frame) {
        scb_record_frame(&engine.recorder, static_cast<Index>(frame));
        engine.move(frame);
        const Rows pose = pose_at(frame);
        scb_record_pose(&engine.recorder, 1, pose.rows);
        scb_record_query(&engine.recorder, 0, 1);
        engine.query(bug == Bug::pose_transposed                         ? transposed(pose)
                     : bug == Bug::pose_of_the_frame_before && frame > 0 ? pose_at(frame - 1)
                                                                         : pose);
        scb_record_query_end(&engine.recorder, 1, 0);
    }
    scb_record_close(&engine.recorder);
}

}  // namespace scb
