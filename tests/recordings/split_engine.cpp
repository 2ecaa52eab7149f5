#include "tests/recordings/split_engine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "scb/triangle_overlap.h"
#define SCB_RECORD_ON
#include <scb_record.h>

namespace scb {
namespace {

using Index = std::uint32_t;
using Polygon = std::vector<Vec3>;

/// A part of a triangle.
struct Part {
    Index triangle = 0;
    Polygon polygon;
};

struct Node {
    Vec3 lower = Vec3::Constant(HUGE_VAL), upper = Vec3::Constant(-HUGE_VAL);
    std::vector<Index> children, triangles;
};

/// The part of the polygon with x[axis] <= at, or with the other sign beyond it.
Polygon cut(const Polygon& polygon, int axis, double at, double sign, bool with_cut) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = sign * (p[axis] - at), at_q = sign * (q[axis] - at);
        if (at_p <= 0) result.push_back(p);
        if (with_cut && at_p * at_q < 0) result.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return result;
}

/// Long triangles about a center, each turned a little against the one before.
struct Fan {
    static constexpr Index count = 24;
    std::vector<Vec3> vertices;
    std::vector<Node> nodes;
    SplitBug bug{};

    Fan(double tilt, SplitBug of) : bug(of) {
        std::vector<Part> parts;
        for (Index i = 0; i < count; ++i) {
            const double angle = 0.26 * i, next = angle + 0.05;
            const double lift = tilt * std::sin(3 * angle);
            const std::array<Vec3, 3> corners = {
                Vec3(-5 * std::cos(angle), -5 * std::sin(angle), -lift),
                Vec3(5 * std::cos(angle), 5 * std::sin(angle), lift + 0.1),
                Vec3(5 * std::cos(next), 5 * std::sin(next), lift - 0.1)};
            vertices.insert(vertices.end(), corners.begin(), corners.end());
            parts.push_back({i, {corners.begin(), corners.end()}});
        }
        build(parts, 0);
    }

    TriangleCorners corners_of(Index triangle) const {
        return {vertices[3 * triangle], vertices[3 * triangle + 1], vertices[3 * triangle + 2]};
    }

    Index build(const std::vector<Part>& parts, int depth) {
        const auto number = static_cast<Index>(nodes.size());
        Node node;
        for (const Part& part : parts)
            for (const Vec3& p : part.polygon) {
                node.lower = node.lower.cwiseMin(p);
                node.upper = node.upper.cwiseMax(p);
            }
        nodes.push_back(node);
        if (parts.size() <= 2 || depth == 6) {
            for (const Part& part : parts) nodes[number].triangles.push_back(part.triangle);
            return number;
        }
        int axis = 0;
        (node.upper - node.lower).maxCoeff(&axis);
        const double at = (node.lower[axis] + node.upper[axis]) / 2;
        for (const double sign : {1.0, -1.0}) {
            std::vector<Part> below;
            for (const Part& part : parts) {
                const bool is_cut = std::any_of(part.polygon.begin(), part.polygon.end(),
                                                [&](const Vec3& p) { return p[axis] < at; }) &&
                                    std::any_of(part.polygon.begin(), part.polygon.end(),
                                                [&](const Vec3& p) { return p[axis] > at; });
                if (bug == SplitBug::part_forgotten && is_cut && sign < 0 && depth == 3) continue;
                Polygon polygon = cut(part.polygon, axis, at, sign,
                                      bug != SplitBug::box_of_corners || depth != 4);
                if (!polygon.empty()) below.push_back({part.triangle, std::move(polygon)});
            }
            if (below.empty()) continue;
            const Index child = build(below, depth + 1);
            nodes[number].children.push_back(child);
        }
        return number;
    }

    void record(scb_recorder& recorder, Index body, const char* name) const {
        std::vector<double> coordinates;
        std::vector<Index> indices;
        for (const Vec3& v : vertices) coordinates.insert(coordinates.end(), {v[0], v[1], v[2]});
        for (Index i = 0; i < 3 * count; ++i) indices.push_back(i);
        scb_record_mesh(&recorder, body, name, coordinates.data(), 8, 0, 3 * count, indices.data(),
                        4, count);
        scb_record_tree(&recorder, body, name, body, nullptr, 0);
        for (Index i = 0; i < nodes.size(); ++i) {
            const Node& node = nodes[i];
            const double box[6] = {node.lower[0], node.lower[1], node.lower[2],
                                   node.upper[0], node.upper[1], node.upper[2]};
            scb_record_node_data data = {};
            data.parent = SCB_RECORD_NONE;
            data.children = node.children.data();
            data.child_count = static_cast<Index>(node.children.size());
            data.items = node.triangles.data();
            data.item_count = static_cast<Index>(node.triangles.size());
            data.volume.kind = SCB_RECORD_AABB;
            data.volume.count = 6;
            data.volume.values = box;
            scb_record_node(&recorder, body, i, &data);
        }
        scb_record_body(&recorder, body, name, body);
    }
};

struct Query {
    const Fan &a, &b;
    scb_recorder& recorder;
    std::set<std::array<Index, 2>> tested{};

    void visit(Index i, Index j) {
        const Node &m = a.nodes[i], &n = b.nodes[j];
        const bool apart =
            (m.lower.array() > n.upper.array()).any() || (n.lower.array() > m.upper.array()).any();
        scb_record_test(&recorder, i, j, apart ? 1 : 0);
        if (apart) return;
        if (!m.children.empty()) {
            for (const Index child : m.children) visit(child, j);
        } else if (!n.children.empty()) {
            for (const Index child : n.children) visit(i, child);
        } else {
            for (const Index s : m.triangles)
                for (const Index t : n.triangles)
                    // Of a triangle in several leaves, once.
                    if (tested.insert({s, t}).second) test(s, t);
        }
    }
    void test(Index s, Index t) {
        const bool meet = triangles_overlap(a.corners_of(s), b.corners_of(t));
        scb_record_items(&recorder, s, t, meet);
        if (meet) scb_record_pair(&recorder, s, t);
    }
};

}  // namespace

void record_split_engine(SplitBug bug, const std::string& path) {
    scb_recorder recorder;
    scb_record_open(&recorder, path.c_str(), "an engine with spatial splits");
    scb_record_setting(&recorder, "results", "pairs");
    scb_record_stage(&recorder, 1, "boxes apart");
    const Fan a(0.5, bug), b(-0.7, SplitBug::none);
    a.record(recorder, 0, "fan");
    b.record(recorder, 1, "other fan");
    scb_record_frame(&recorder, 0);
    scb_record_query(&recorder, 0, 1);
    Query{a, b, recorder}.visit(0, 0);
    scb_record_query_end(&recorder, 1, 0);
    scb_record_close(&recorder);
}

}  // namespace scb
