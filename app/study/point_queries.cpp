#include "app/study/point_queries.h"

#include "core/geometry/mesh_parts.h"

namespace scb::app {

std::optional<double> PointAnswer::signed_distance() const {
    if (!side) return std::nullopt;
    return *side == PointSide::in ? -nearest.found.distance : nearest.found.distance;
}

PointQueries::PointQueries(const Mesh& mesh, const BuildOptions& build)
    : mesh_(mesh),
      hierarchy_(build_hierarchy<Scb2>(mesh, build)),
      of_probe_(build_hierarchy<Scb2>(probe_)) {
    if (are_closed(joined_triangles(mesh))) parity_.emplace(mesh, *hierarchy_.topology);
}

PointAnswer PointQueries::at(const Vec3& point) {
    Pose pose;
    pose.translation = point;
    DistanceOptions options;
    options.seed = last_;
    PointAnswer answer;
    answer.nearest = distance(Collider<Scb2>{hierarchy_, mesh_}, Collider<Scb2>{of_probe_, probe_},
                              pose, options);
    last_ = answer.nearest.triangles;
    if (parity_) answer.side = parity_->side(point);
    return answer;
}

}  // namespace scb::app
