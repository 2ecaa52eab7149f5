#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

#include "scb/collide.h"
#include "scb/error.h"
#include "scb/triangle_overlap.h"
#include "tests/peers/adapters.h"
#include "tests/peers/core_mesh.h"

namespace scb {
namespace {

/// The float next below or above a double, so that boxes contain what they are made of.
float rounded_down(double x) {
    const auto nearest = static_cast<float>(x);
    return nearest <= x ? nearest : std::nextafter(nearest, -INFINITY);
}
float rounded_up(double x) {
    const auto nearest = static_cast<float>(x);
    return nearest >= x ? nearest : std::nextafter(nearest, INFINITY);
}

/// A mesh, its vertices where they are now, and Embree's tree over them: rtcCollide knows only
/// scenes of user geometries, in one frame.
struct Body {
    Body(RTCDevice device, const PeerMesh& from, bool moves)
        : mesh(core_mesh(from)), scene(rtcNewScene(device)) {
        if (moves) {
            rtcSetSceneFlags(scene, RTC_SCENE_FLAG_DYNAMIC);
            rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
        }
        geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry,
                                         static_cast<unsigned int>(mesh.triangles.size()));
        rtcSetGeometryUserData(geometry, this);
        rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
        // Boxes are fitted again instead of a new tree, which takes three times as long.
        if (moves) rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        placed = mesh.vertices;
        rtcCommitScene(scene);
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;
    ~Body() {
        rtcReleaseScene(scene);
        rtcReleaseGeometry(geometry);
    }

    static void bounds(const RTCBoundsFunctionArguments* arguments) {
        const Body& body = *static_cast<const Body*>(arguments->geometryUserPtr);
        const TriangleCorners t = body.triangle(arguments->primID);
        const Vec3 lower = t[0].cwiseMin(t[1]).cwiseMin(t[2]),
                   upper = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
        *arguments->bounds_o = {
            rounded_down(lower[0]), rounded_down(lower[1]), rounded_down(lower[2]), 0,
            rounded_up(upper[0]),   rounded_up(upper[1]),   rounded_up(upper[2]),   0};
    }

    TriangleCorners triangle(std::uint32_t i) const {
        const Triangle& t = mesh.triangles[i];
        return {placed[t[0]], placed[t[1]], placed[t[2]]};
    }

    void move(const Pose& pose) {
        for (std::size_t i = 0; i < placed.size(); ++i)
            placed[i] = transform_point(pose, mesh.vertices[i]);
        rtcCommitGeometry(geometry);
        rtcCommitScene(scene);
    }

    Mesh mesh;
    std::vector<Vec3> placed;
    RTCScene scene;
    RTCGeometry geometry = nullptr;
};

/// Counts the memory that a device has.
bool count_memory(void* bytes, ssize_t change, bool) {
    *static_cast<ssize_t*>(bytes) += change;
    return true;
}

class EmbreePeer : public Peer {
  public:
    EmbreePeer(const PeerMesh& a, const PeerMesh& b) : device_(rtcNewDevice("threads=1")) {
        if (!device_)
            throw InputError(
                "--peers embree: Embree does not start on this machine; leave it out.");
        rtcSetDeviceMemoryMonitorFunction(device_, count_memory, &bytes_);
        a_ = std::make_unique<Body>(device_, a, false);
        b_ = std::make_unique<Body>(device_, b, true);
    }
    ~EmbreePeer() override {
        a_.reset();
        b_.reset();
        rtcReleaseDevice(device_);
    }

    void query(const PeerPose& a, const PeerPose& b) override {
        found_.clear();
        b_->move(relative_pose(core_pose(a), core_pose(b)));
        rtcCollide(a_->scene, b_->scene, collect, this);
    }

    std::vector<IndexPair> pairs() const override {
        std::vector<IndexPair> pairs = found_;
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    double bytes() const override { return static_cast<double>(bytes_); }

  private:
    static void collect(void* user, RTCCollision* collisions, unsigned int count) {
        EmbreePeer& peer = *static_cast<EmbreePeer*>(user);
        for (unsigned int i = 0; i < count; ++i) {
            const IndexPair pair{collisions[i].primID0, collisions[i].primID1};
            if (triangles_overlap(peer.a_->triangle(pair.a), peer.b_->triangle(pair.b)))
                peer.found_.push_back(pair);
        }
    }

    ssize_t bytes_ = 0;
    RTCDevice device_;
    std::unique_ptr<Body> a_, b_;
    std::vector<IndexPair> found_;
};

}  // namespace

PeerKind embree_peer() {
    PeerKind kind;
    kind.name = "embree";
    kind.title = "Embree " RTC_VERSION_STRING ", rtcCollide";
    kind.method =
        "`rtcCollide`, which needs both bodies in one frame: B's vertices are moved and "
        "its tree's boxes are fitted again in every query; pairs of boxes are decided by this "
        "project's exact test of two triangles, as Embree has none.";
    kind.prepare = [](const PeerMesh& a, const PeerMesh& b, PeerQuery) {
        return std::make_unique<EmbreePeer>(a, b);
    };
    return kind;
}

}  // namespace scb
