#include "core/judge/engine_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/judge/left_out_tests.h"
#include "core/judge/test_links.h"
#include "scb/triangle_distance.h"

namespace scb {
namespace {

using Kind = EngineEvent::Kind;

std::uint16_t depth_of(const EngineSide& side, std::uint32_t node) {
    const std::uint32_t depth = side.shape->depths[node];
    // The node is unreachable.
    if (depth == no_index) return 0;
    return static_cast<std::uint16_t>(
        std::min<std::uint32_t>(depth, std::numeric_limits<std::uint16_t>::max()));
}

/// Per object, the first node that holds it.
std::unordered_map<std::uint32_t, std::uint32_t> holders_of(const EngineSide& side) {
    std::unordered_map<std::uint32_t, std::uint32_t> holders;  // lookups only
    for (const std::uint32_t node : side.shape->order)
        for (const std::uint32_t object : side.tree->items(node)) holders.try_emplace(object, node);
    return holders;
}

/// The pairs of objects as pairs of the nodes that hold them.
std::vector<IndexPair> pairs_of_holders(const EngineQuery& query, std::vector<IndexPair> pairs) {
    const auto of_a = holders_of(query.sides[0]), of_b = holders_of(query.sides[1]);
    std::vector<IndexPair> nodes;
    for (const IndexPair pair : pairs) {
        const auto a = of_a.find(pair.a), b = of_b.find(pair.b);
        if (a != of_a.end() && b != of_b.end()) nodes.push_back({a->second, b->second});
    }
    return nodes;
}

bool are_objects(const EngineQuery& query) { return !query.sides[0].mesh || !query.sides[1].mesh; }

/// Whether the items are objects, or triangles that exist. The judgement reports other triangles.
bool exist(const EngineQuery& query, IndexPair items) {
    return are_objects(query) || (items.a < query.sides[0].mesh->triangles.size() &&
                                  items.b < query.sides[1].mesh->triangles.size());
}

/// The recorded distance and its triangles, as the pair that the query found.
void take_answer(const EngineQuery& query, QueryTrace& frame) {
    frame.found.pairs.clear();
    if (!query.answer || !std::isfinite(query.answer->distance)) return;
    const EngineAnswer& answer = *query.answer;
    if (answer.items.a == no_index || answer.items.b == no_index || !exist(query, answer.items))
        return;
    frame.found.pairs.push_back(answer.items);
    TriangleDistance& nearest = frame.nearest.emplace();
    if (answer.points) {
        const Pose to_a = relative_pose(query.a_to_world, Pose{});
        nearest.point_a = transform_point(to_a, (*answer.points)[0]);
        nearest.point_b = transform_point(to_a, (*answer.points)[1]);
    } else if (!are_objects(query)) {
        nearest = triangle_distance(
            corners(*query.sides[0].mesh, answer.items.a),
            transform_corners(query.b_to_a, corners(*query.sides[1].mesh, answer.items.b)));
    }
    nearest.distance = answer.distance;
}

}  // namespace

QueryTrace trace_frame(const EngineQuery& query, const std::map<std::uint8_t, Stage>& stages) {
    QueryTrace frame{query.frame, query.b_to_a, {}, {}, {}};
    Collision& found = frame.found;
    TestLinks links(query);
    const std::vector<bool> left_out = left_out_tests(query);
    std::vector<std::uint32_t> place;  // per test of volumes: its index in the frame, or no_index
    for (const EngineEvent& event : query.events) {
        if (event.kind == Kind::pair) {
            if (exist(query, {event.a, event.b})) found.pairs.push_back({event.a, event.b});
            continue;
        }
        if (event.kind != Kind::volumes) {
            ++found.n_p;
            const IndexPair items{event.a, event.b};
            const bool meet = event.kind == Kind::items_meet;
            if (!exist(query, items)) continue;
            if (meet && !query.has_pairs) found.pairs.push_back(items);
            const std::uint32_t led_by = links.led_to_items(items);
            if (!are_objects(query) && led_by != no_index && place[led_by] != no_index)
                frame.steps.items.push_back({items, place[led_by], meet});
            continue;
        }
        const IndexPair nodes = nodes_of(query, event);
        const std::uint32_t led_by =
            links.take_volumes(nodes, event.stage == 0, event.parent).led_by;
        if (nodes.a == no_index || nodes.b == no_index) {
            place.push_back(no_index);
            continue;
        }
        const bool is_left_out = !left_out.empty() && left_out[place.size()];
        const Stage stage = event.stage != 0 ? stages.at(event.stage)
                            : is_left_out    ? stages.at(left_out_stage)
                                             : Stage::overlapping;
        place.push_back(static_cast<std::uint32_t>(frame.steps.volumes.size()));
        frame.steps.volumes.push_back({nodes, depth_of(query.sides[0], nodes.a),
                                       depth_of(query.sides[1], nodes.b), stage,
                                       led_by == no_index ? no_step : place[led_by]});
        if (const auto row = static_cast<std::size_t>(stage); row < stage_count)
            ++found.stages[row];
        const Step& test = frame.steps.volumes.back();
        found.depth = std::max(found.depth, test.depth_a + test.depth_b);
    }
    std::stable_sort(frame.steps.items.begin(), frame.steps.items.end(),
                     [](const ItemStep& x, const ItemStep& y) { return x.step < y.step; });
    found.n_v = frame.steps.volumes.size();
    found.complete = query.complete;
    if (query.kind == QueryKind::distance) take_answer(query, frame);
    if (are_objects(query)) found.pairs = pairs_of_holders(query, std::move(found.pairs));
    std::sort(found.pairs.begin(), found.pairs.end());
    found.pairs.erase(std::unique(found.pairs.begin(), found.pairs.end()), found.pairs.end());
    return frame;
}

}  // namespace scb
