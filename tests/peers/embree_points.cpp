#include <embree3/rtcore.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/peers/point_peer.h"

namespace scb {
namespace {

using Point = Eigen::Vector3d;

/// The point of the segment from a to b that is nearest to p.
Point nearest_on(const Point& p, const Point& a, const Point& b) {
    const Point ab = b - a;
    const double length = ab.squaredNorm();
    if (length == 0) return a;
    return a + std::fmin(1, std::fmax(0, ab.dot(p - a) / length)) * ab;
}

double triangle_distance(const Point& p, const Point& a, const Point& b, const Point& c) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        least = std::fmin(least, (p - nearest_on(p, from, to)).norm());
    const Point normal = (b - a).cross(c - a);
    if (normal.isZero(0)) return least;
    const bool is_above = normal.cross(b - a).dot(p - a) >= 0 &&
                          normal.cross(c - b).dot(p - b) >= 0 &&
                          normal.cross(a - c).dot(p - c) >= 0;
    return is_above ? std::fmin(least, std::abs(normal.normalized().dot(p - a))) : least;
}

class EmbreePointPeer : public PointPeer {
  public:
    explicit EmbreePointPeer(const PeerMesh& mesh)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)), triangles_(mesh.triangles) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* corners = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.vertices.size()));
        for (const auto& v : mesh.vertices) {
            for (const double x : v) *corners++ = static_cast<float>(x);
            corners_.push_back(Point(static_cast<float>(v[0]), static_cast<float>(v[1]),
                                     static_cast<float>(v[2])));
        }
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), mesh.triangles.size()));
        for (const auto& t : mesh.triangles)
            for (const std::uint32_t i : t) *indices++ = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreePointPeer() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    double distance(const std::array<double, 3>& point) override {
        point_ = Point(point[0], point[1], point[2]);
        least_ = std::numeric_limits<double>::infinity();
        RTCPointQuery query{};
        query.x = static_cast<float>(point[0]);
        query.y = static_cast<float>(point[1]);
        query.z = static_cast<float>(point[2]);
        query.radius = std::numeric_limits<float>::infinity();
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(scene_, &query, &context, visit, this);
        return least_;
    }

  private:
    static bool visit(RTCPointQueryFunctionArguments* args) {
        auto& self = *static_cast<EmbreePointPeer*>(args->userPtr);
        const auto& t = self.triangles_[args->primID];
        const double found = triangle_distance(self.point_, self.corners_[t[0]],
                                               self.corners_[t[1]], self.corners_[t[2]]);
        if (!(found < self.least_)) return false;
        self.least_ = found;
        args->query->radius = static_cast<float>(found);
        return true;
    }

    RTCDevice device_;
    RTCScene scene_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Point> corners_;
    Point point_ = Point::Zero();
    double least_ = 0;
};

}  // namespace

std::unique_ptr<PointPeer> embree_point_peer(const PeerMesh& mesh) {
    return std::make_unique<EmbreePointPeer>(mesh);
}

}  // namespace scb
