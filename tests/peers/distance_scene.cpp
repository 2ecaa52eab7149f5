#include "tests/peers/distance_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/base/text_format.h"
#include "core/geometry/mesh_facts.h"
#include "scenes/scene/motion.h"
#include "tests/peers/core_mesh.h"

namespace scb {
namespace {

double distance_at(const DistanceBodies& bodies, const Pose& b_to_a) {
    return distance_packed(PackedCollider{bodies.a.packed, bodies.a.mesh},
                           PackedCollider{bodies.b.packed, bodies.b.mesh}, b_to_a)
        .found.distance;
}

/// Random poses of B in which the bodies are this far apart.
std::vector<PeerPoses> poses_at_gap(const DistanceBodies& bodies, double gap, std::size_t count) {
    Random random(7);
    const auto direction = [&random] {
        return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    std::vector<PeerPoses> poses;
    while (poses.size() < count) {
        Pose pose;
        pose.rotation = scenes::rotation_about(direction(), random.uniform(0, 360));
        const Vec3 way = direction().normalized();
        // From far away towards A: the bodies are first this far apart where they have not met.
        double far = 4 + gap, near = 0;
        const auto move = [&](double length) {
            pose.translation = length * way;
            return distance_at(bodies, pose);
        };
        while (far - near > 1e-8 * gap && std::abs(move(far) - gap) > 1e-6 * gap) {
            const double middle = (far + near) / 2;
            (move(middle) > gap ? far : near) = middle;
        }
        poses.push_back({peer_pose(Pose{}), peer_pose(pose)});
    }
    return poses;
}

}  // namespace

Mesh normalized(const Mesh& mesh) {
    const Box box = bounding_box(mesh);
    const double scale = 1 / (box.upper - box.lower).maxCoeff();
    const Vec3 middle = (box.lower + box.upper) / 2;
    Mesh result = mesh;
    for (Vec3& vertex : result.vertices) vertex = scale * (vertex - middle);
    return result;
}

DistanceScene scene_of_gaps(const Mesh& mesh, const std::vector<double>& gaps, std::size_t poses) {
    const Mesh scaled = normalized(mesh);
    DistanceScene result{std::make_unique<DistanceBodies>(scaled, scaled), {}};
    for (const double gap : gaps)
        result.rows.push_back({exact_number(gap), poses_at_gap(*result.bodies, gap, poses)});
    return result;
}

DistanceScene scene_of_frames(const scenes::Scene& scene, std::size_t frames) {
    const scenes::Body &a = scene.bodies[0], &b = scene.bodies[1];
    DistanceScene result{
        std::make_unique<DistanceBodies>(scene.meshes[a.mesh].mesh, scene.meshes[b.mesh].mesh),
        {{"-", {}}}};
    for (std::size_t i = 0; i < frames; ++i) {
        const auto frame = static_cast<int>(i * static_cast<std::size_t>(scene.frames) / frames);
        result.rows[0].poses.push_back({peer_pose(scenes::pose_at(a.motion, frame)),
                                        peer_pose(scenes::pose_at(b.motion, frame))});
    }
    return result;
}

}  // namespace scb
