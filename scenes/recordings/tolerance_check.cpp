#include "scenes/recordings/tolerance_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text_format.h"
#include "scb/triangle_overlap.h"
#include "scenes/recordings/judgement_words.h"

namespace scb::scenes {
namespace {

std::string step_words(double at, bool single) {
    return std::string("where ") + (single ? "32" : "64") + "-bit numbers are up to " +
           format("%.2g", at * (single ? 0x1p-23 : 0x1p-52)) + " apart";
}

/// The cause of the tolerance, as a clause that begins with "; ".
std::string cause_of_tolerance(const EngineQuery& query) {
    switch (query.tolerance_cause) {
        case ToleranceCause::setting:
            return "; the setting `tolerance` of the recording says so";
        case ToleranceCause::pose:
            return "; the rotation of a body is not exact";
        case ToleranceCause::distance:
            return "; bodies stand " + format("%.3g", query.away) + " from the origin, " +
                   step_words(query.away, query.single);
        case ToleranceCause::reach:
            break;
    }
    return "; coordinates reach " + format("%.3g", query.reach) + ", " +
           step_words(query.reach, query.single);
}

std::vector<std::pair<double, double>> sizes_of(const EngineSide& side) {
    std::vector<std::pair<double, double>> sizes;
    if (side.mesh) {
        for (std::uint32_t i = 0; i < side.mesh->triangles.size(); ++i) {
            if (!has_finite_corners(*side.mesh, i)) continue;
            const TriangleCorners t = corners(*side.mesh, i);
            sizes.emplace_back(std::sqrt(std::max({squared_norm(Vec3(t[1] - t[0])),
                                                   squared_norm(Vec3(t[2] - t[1])),
                                                   squared_norm(Vec3(t[0] - t[2]))})),
                               0);
        }
    } else {
        for (const std::uint32_t node : side.shape->order)
            if (side.shape->is_leaf(node) && has_volume((*side.tree)[node].volume))
                sizes.emplace_back(diameter(convex_shape((*side.tree)[node].volume)),
                                   (*side.tree)[node].reach);
    }
    // A single point has no extent that a tolerance could hide.
    std::erase_if(sizes, [](const auto& size) { return !(size.first > 0); });
    std::sort(sizes.begin(), sizes.end());
    return sizes;
}

}  // namespace

void ToleranceCheck::take(const RecordedQueries& recording, const EngineQuery& query,
                          const std::map<std::uint32_t, std::string>& body_names,
                          FrameTolerance& tolerance) {
    tolerance.volumes = std::max(tolerance.volumes, query.tolerance);
    tolerance.triangles = std::max(tolerance.triangles, query.triangle_tolerance);
    tolerance.away = std::max(tolerance.away, query.away);
    tolerance.single |= query.single;
    const auto bodies = recording.query_bodies();
    for (std::size_t k = 0; k < 2; ++k) {
        const EngineSide& side = query.sides[k];
        const double other = query.sides[1 - k].reach;
        look(
            items_of(of_bodies_, bodies[k], side), side, body_names.at(bodies[k]),
            [&](double reach) {
                if (side.mesh) return query.triangle_tolerance;
                return tolerance_at(query, k == 0 ? reach : other, k == 0 ? other : reach);
            },
            query.frame, cause_of_tolerance(query), tolerance);
    }
}

void ToleranceCheck::take_trees(RecordedQueries& recording, FrameTolerance& tolerance) {
    std::set<std::uint32_t> of_bodies;
    for (const auto& [number, body] : recording.bodies()) of_bodies.insert(body.tree);
    for (const auto& [number, tree] : recording.trees()) {
        if (of_bodies.contains(number)) continue;
        const EngineSide side = recording.side_of(number);
        tolerance.volumes = std::max(tolerance.volumes, recording.tolerance_of(tree));
        const NodeTolerance of_nodes = recording.node_tolerance_of(tree);
        look(
            items_of(of_trees_, number, side), side, tree_words(recording, number),
            [&](double reach) { return of_nodes.of(reach); }, recording.frame(), "", tolerance);
    }
}

void ToleranceCheck::look(Items& items, const EngineSide& side, const std::string& name,
                          const std::function<double(double)>& tolerance_at, int frame,
                          const std::string& cause, FrameTolerance& tolerance) {
    std::uint64_t hidden = 0;
    double within = 0;
    if (side.mesh) {
        within = tolerance_at(0);
        hidden = static_cast<std::uint64_t>(
            std::partition_point(items.sizes.begin(), items.sizes.end(),
                                 [within](const auto& item) { return item.first <= within; }) -
            items.sizes.begin());
    } else {
        for (const auto& [size, reach] : items.sizes) {
            const double of_leaf = tolerance_at(reach);
            if (size > of_leaf) continue;
            ++hidden;
            within = std::max(within, of_leaf);
        }
    }
    if (hidden == 0) return;
    items.hidden = std::max(items.hidden, hidden);
    if (tolerance.hides.empty())
        tolerance.hides = std::to_string(hidden) + " of " + std::to_string(items.sizes.size()) +
                          (side.mesh ? " triangles of " : " leaf volumes of ") + name +
                          " are not larger";
    if (why_.empty())
        why_ = "at frame " + std::to_string(frame) + " the tolerance is " + format("%.3g", within) +
               ", and " + tolerance.hides + cause;
}

ToleranceCheck::Items& ToleranceCheck::items_of(std::map<std::uint32_t, Items>& all,
                                                std::uint32_t number, const EngineSide& side) {
    Items& known = all[number];
    if (known.tree == side.tree && known.version == side.version) return known;
    known.tree = side.tree;
    known.version = side.version;
    known.sizes = sizes_of(side);
    return known;
}

std::uint64_t ToleranceCheck::hidden() const {
    std::uint64_t count = 0;
    for (const auto* all : {&of_bodies_, &of_trees_})
        for (const auto& [number, items] : *all) count += items.hidden;
    return count;
}

std::uint64_t ToleranceCheck::of() const {
    std::uint64_t count = 0;
    for (const auto* all : {&of_bodies_, &of_trees_})
        for (const auto& [number, items] : *all) count += items.sizes.size();
    return count;
}

}  // namespace scb::scenes
