#include "render/figures/contact_areas.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/common_area.h"

namespace scb::render {
namespace {

/// Ends of edges this far apart are at one place, as a part of the extent of all areas.
constexpr double at_one_place = 1e-6;
/// Areas whose normals have at least this cosine are in one plane if they share an edge.
constexpr double least_cosine = 0.9999;

struct Edge {
    Vec3 p, q;
    Vec3 normal;      ///< of its area, a unit vector
    Vec3 outward;     ///< away from its area, in its plane, as long as the edge
    double position;  ///< of its middle along `sweep`
    std::uint32_t id;
    bool is_inner = false;  ///< between two areas, or there already
};

/// Seldom perpendicular to a plane of a model, so that few edges have the same position.
const Vec3 sweep{0.3713, 0.5571, 0.7428};

bool is_same(const Edge& e, const Edge& f, double near) {
    const auto close = [near](const Vec3& p, const Vec3& q) {
        return squared_norm<double>(p - q) <= near * near;
    };
    return std::abs(dot(e.normal, f.normal)) >= least_cosine &&
           ((close(e.p, f.p) && close(e.q, f.q)) || (close(e.p, f.q) && close(e.q, f.p)));
}

}  // namespace

std::vector<Area> contact_areas(const QueryBodies& bodies, const QueryTrace& frame) {
    auto common = of_pairs<std::vector<Vec3>>(bodies, frame, common_area);
    std::vector<Area> areas;
    for (std::size_t i = 0; i < common.size(); ++i) {
        if (common[i].empty()) continue;
        for (Vec3& corner : common[i]) corner = transform_point(bodies[0].pose, corner);
        areas.push_back({std::move(common[i]), Rgba8{}, static_cast<std::uint32_t>(i)});
    }
    return areas;
}

std::vector<Segment> outlines_of(const std::vector<Area>& areas) {
    std::vector<Edge> edges;
    Box box;
    for (const Area& area : areas) {
        const Vec3 normal = area_normal(area.corners);
        const double length = std::sqrt(squared_norm(normal));
        for (std::size_t i = 0; i < area.corners.size(); ++i) {
            const Vec3 &p = area.corners[i], &q = area.corners[(i + 1) % area.corners.size()];
            edges.push_back({p, q, normal / length, cross(q - p, normal / length),
                             dot(sweep, p + q) / 2, area.id});
            box.add(p);
        }
    }
    if (edges.empty()) return {};
    const double near = at_one_place * std::sqrt(squared_norm<double>(box.upper - box.lower));
    std::vector<std::uint32_t> order(edges.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&edges](std::uint32_t i, std::uint32_t j) {
        return edges[i].position != edges[j].position ? edges[i].position < edges[j].position
                                                      : i < j;
    });
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            Edge &e = edges[order[i]], &f = edges[order[j]];
            if (f.position - e.position > near) break;
            if (!is_same(e, f, near)) continue;
            if (dot(e.outward, f.outward) < 0)
                e.is_inner = f.is_inner = true;
            else
                (e.id <= f.id ? f : e).is_inner = true;  // areas that lie on each other
        }
    std::vector<Segment> outlines;
    for (const Edge& edge : edges)
        if (!edge.is_inner) outlines.push_back({edge.p, edge.q, Rgba8{}, edge.id});
    return outlines;
}

}  // namespace scb::render
