#include "tests/recordings/distance_engine.h"

#include <limits>

#include "scb/triangle_distance.h"
#include "tests/recordings/small_sheet.h"

namespace scb {
namespace {

using namespace small;

constexpr double tolerance = 1.5;

/// Both bodies, and a depth-first search that visits the nearer pair first.
struct Engine {
    static constexpr Index forgotten = 24;  ///< node of B
    DistanceBug bug = DistanceBug::none;
    scb_recorder recorder{};
    std::array<Sheet, 2> sheets;
    // Of the current query.
    Rows pose{};
    double limit = 0;   ///< nothing beyond it is looked for
    bool near = false;  ///< all pairs within the limit; else the nearest pair
    TriangleDistance best{};
    std::array<Index, 2> closest{};
    std::vector<std::array<Index, 2>> pairs{};
    std::size_t left = 0;  ///< pairs of nodes that stay on the stack

    void record_node(Index tree, Index number, bool refit) {
        const Node& node = sheets[tree].nodes[number];
        const Volume& v = node.volume;
        const double values[4] = {v.center[0], v.center[1], v.center[2], v.radius};
        const scb_record_volume volume = {SCB_RECORD_BALL, 4, values};
        small::record_node(recorder, tree, number, node, volume, refit);
    }
    void build(Index number) {
        Sheet& sheet = sheets[number];
        sheet.wave(0.5);
        sheet.build();
        sheet.refit(0, SCB_RECORD_NONE);
        record_mesh(recorder, number, sheet);
        scb_record_tree(&recorder, number, "sheet", number, nullptr, 0);
        for (Index i = 0; i < sheet.nodes.size(); ++i) record_node(number, i, false);
        scb_record_body(&recorder, number, number == 0 ? "lower" : "upper", number);
    }
    /// The mesh of B waves on.
    void move(int frame) {
        Sheet& sheet = sheets[1];
        sheet.wave(0.5 - 0.25 * frame);
        const bool forgets = bug == DistanceBug::stale_node && frame == 2;
        sheet.refit(0, forgets ? forgotten : SCB_RECORD_NONE);
        record_mesh(recorder, 1, sheet);
        for (Index i = 0; i < sheet.nodes.size(); ++i)
            if (!(forgets && i == forgotten)) record_node(1, i, true);
    }

    /// A lower bound of the distance of two nodes.
    double bound(Index i, Index j) const {
        const Volume &a = sheets[0].nodes[i].volume, &b = sheets[1].nodes[j].volume;
        const Vector center = place(pose, b.center);
        double squared = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double along = center[k] - a.center[k];
            squared += along * along;
        }
        const double gap = std::sqrt(squared) - a.radius -
                           (bug == DistanceBug::wrong_radius ? a.radius : b.radius);
        if (bug == DistanceBug::nan_bound && gap < 0)
            return std::numeric_limits<double>::quiet_NaN();
        return std::max(0.0, gap);
    }
    TriangleDistance measured(Index i, Index j) const {
        TriangleCorners a, b;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector& x = sheets[0].vertices[sheets[0].triangles[i][k]];
            const Vector y = place(pose, sheets[1].vertices[sheets[1].triangles[j][k]]);
            a[k] = {x[0], x[1], x[2]};
            b[k] = {y[0], y[1], y[2]};
        }
        TriangleDistance found = triangle_distance(a, b);
        if (bug == DistanceBug::wrong_point) found.point_b = b[0];
        return found;
    }
    void measure(Index i, Index j) {
        const TriangleDistance found = measured(i, j);
        scb_record_item_distance(&recorder, i, j, found.distance);
        if (near && found.distance <= limit) pairs.push_back({i, j});
        if (near || !(found.distance < best.distance)) return;
        best = found;
        closest = {i, j};
    }
    bool is_left_out(double lower) const {
        const double most = near ? limit : best.distance;
        if (bug == DistanceBug::squared_bound && !near) return lower * lower >= most;
        return near ? lower > most : lower >= most;
    }

    void search() {
        struct Pair {
            Index i, j;
            double lower;
        };
        const auto tested = [this](Index i, Index j) {
            const double lower = bound(i, j);
            scb_record_bound(&recorder, i, j, lower, 0);
            return Pair{i, j, lower};
        };
        std::vector<Pair> stack = {tested(0, 0)};
        while (stack.size() > left) {
            const Pair at = stack.back();
            stack.pop_back();
            left = bug == DistanceBug::early_stop;
            if (is_left_out(at.lower)) continue;
            const Node &a = sheets[0].nodes[at.i], &b = sheets[1].nodes[at.j];
            if (a.children.empty() && b.children.empty()) {
                measure(a.triangle, b.triangle);
                continue;
            }
            const bool divide_a =
                b.children.empty() || (!a.children.empty() && a.volume.radius > b.volume.radius);
            std::vector<Pair> below;
            for (const Index child : divide_a ? a.children : b.children)
                below.push_back(divide_a ? tested(child, at.j) : tested(at.i, child));
            if (below[0].lower < below[1].lower) std::swap(below[0], below[1]);
            stack.insert(stack.end(), below.begin(), below.end());
        }
        left = 0;
    }

    void look_for_nearest(bool is_first) {
        scb_record_named_query(&recorder, 0, 1, "nearest", nullptr, 0);
        scb_record_nearest(&recorder, HUGE_VAL, 0);
        near = false;
        if (bug != DistanceBug::old_seed || is_first) best.distance = HUGE_VAL;
        search();
        const Vec3 &p = best.point_a, &q = best.point_b;
        const double points[6] = {p[0], p[1], p[2], q[0], q[1], q[2]};
        if (bug == DistanceBug::swapped_bodies) std::swap(closest[0], closest[1]);
        scb_record_distance(&recorder, best.distance * (bug == DistanceBug::wrong_units ? 1000 : 1),
                            closest[0], closest[1], points);
        scb_record_query_end(&recorder, 1, 0);
    }
    void look_within() {
        scb_record_named_query(&recorder, 0, 1, "near", nullptr, 0);
        scb_record_within(&recorder, tolerance);
        near = true;
        limit = (bug == DistanceBug::tolerance_twice ? 2 : 1) * tolerance;
        pairs.clear();
        search();
        for (const auto& [i, j] : pairs) scb_record_pair(&recorder, i, j);
        scb_record_query_end(&recorder, 1, 0);
    }
};

/// B turns about z, and rises.
Rows pose_at(int frame) {
    constexpr double sines[] = {0, 7.0 / 25, 3.0 / 5, 4.0 / 5},
                     cosines[] = {1, 24.0 / 25, 4.0 / 5, 3.0 / 5};
    const double s = sines[frame], c = cosines[frame];
    return {{c, -s, 0, 0.1 * frame, s, c, 0, 0.05, 0, 0, 1, 1.75 + 0.125 * frame}};
}

}  // namespace

void record_distance_engine(DistanceBug bug, const std::string& path) {
    Engine engine;
    engine.bug = bug;
    scb_record_open(&engine.recorder, path.c_str(), "a small engine of distances");
    scb_record_setting(&engine.recorder, "results", "pairs");
    for (const Index body : {0u, 1u}) engine.build(body);
    for (int frame = 0; frame < 4; ++frame) {
        scb_record_frame(&engine.recorder, static_cast<Index>(frame));
        engine.move(frame);
        engine.pose = pose_at(frame);
        scb_record_pose(&engine.recorder, 1, engine.pose.rows);
        engine.look_for_nearest(frame == 0);
        engine.look_within();
    }
    scb_record_close(&engine.recorder);
}

}  // namespace scb
