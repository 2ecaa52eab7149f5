#include "scenes/recordings/tolerance_check.h"

#include <algorithm>
#include <cmath>

#include "core/base/text_format.h"
#include "scb/triangle_overlap.h"

namespace scb::scenes {
namespace {

std::string cause_of_tolerance(const EngineQuery& query) {
    if (!(query.away > 0)) return "";
    const double step = query.away * (query.single ? 0x1p-23 : 0x1p-52);
    return "; bodies stand " + format("%.3g", query.away) + " from the origin, where " +
           (query.single ? "32" : "64") + "-bit numbers are up to " + format("%.2g", step) +
           " apart";
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
    for (std::size_t side = 0; side < 2; ++side) {
        const double size = size_of_items(bodies[side], query.sides[side]);
        const bool has_mesh = query.sides[side].mesh;
        const double within = has_mesh ? query.triangle_tolerance : query.tolerance;
        if (!(size > 0) || within < size) continue;
        ++hidden_;
        if (tolerance.hides.empty())
            tolerance.hides =
                (has_mesh ? "half of the triangles of " : "half of the leaf volumes of ") +
                body_names.at(bodies[side]) + " are smaller than " + format("%.3g", size);
        if (hidden_why_.empty())
            hidden_why_ = "at frame " + std::to_string(query.frame) + " the tolerance is " +
                          format("%.3g", within) + ", and " + tolerance.hides +
                          cause_of_tolerance(query);
        return;
    }
}

/// Half of the triangles, or of the volumes of leaves, of a body are smaller.
double ToleranceCheck::size_of_items(std::uint32_t body, const EngineSide& side) {
    SizeOfItems& known = sizes_[body];
    if (known.tree == side.tree && known.version == side.version) return known.size;
    known.tree = side.tree;
    known.version = side.version;
    std::vector<double> sizes;
    if (side.mesh) {
        for (std::uint32_t i = 0; i < side.mesh->triangles.size(); ++i) {
            if (!has_finite_corners(*side.mesh, i)) continue;
            const TriangleCorners t = corners(*side.mesh, i);
            sizes.push_back(std::sqrt(
                std::max({squared_norm(Vec3(t[1] - t[0])), squared_norm(Vec3(t[2] - t[1])),
                          squared_norm(Vec3(t[0] - t[2]))})));
        }
    } else {
        for (const std::uint32_t node : side.shape->order)
            if (side.shape->is_leaf(node) && has_volume((*side.tree)[node].volume))
                sizes.push_back(diameter(convex_shape((*side.tree)[node].volume)));
    }
    if (sizes.empty()) return known.size = 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return known.size = *middle;
}

}  // namespace scb::scenes
