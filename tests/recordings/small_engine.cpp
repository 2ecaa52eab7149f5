#include "tests/recordings/small_engine.h"

#include <algorithm>
#include <cmath>
#include "scb/triangle_overlap.h"
#include "tests/recordings/small_sheet.h"
#define SCB_RECORD_ON
#include <scb_record.h>

namespace scb {
namespace {

using namespace small;

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
        small::record_node(recorder, tree, number, node, volume, refit);
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
        record_mesh(recorder, number, sheet);
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
        record_mesh(recorder, 1, sheet);
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
