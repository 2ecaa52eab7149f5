#include "app/study/tune_subject.h"

#include "app/study/near_query.h"
#include "core/base/statistics.h"
#include "core/platform/clock.h"
#include "scenes/scene/scene_hierarchies.h"

namespace scb::app {

TuneSubject::TuneSubject(const scenes::Scene& scene, std::size_t a, std::size_t b,
                         const std::vector<int>& frames, const BuildOptions& build)
    : scene_(scene), build_(build), mesh_a_(scene.bodies[a].mesh), mesh_b_(scene.bodies[b].mesh) {
    if (a == b) joined_ = joined_vertices(scene.meshes[mesh_a_].mesh);
    for (const int frame : frames)
        poses_.push_back(relative_pose(scenes::pose_at(scene.bodies[a].motion, frame),
                                       scenes::pose_at(scene.bodies[b].motion, frame)));
}

BuiltSetting TuneSubject::build(const TuneSetting& setting) {
    BuildOptions options = build_;
    options.split = setting.split;
    options.fit.growth = setting.growth;
    Split* split = &splits_[setting.split == SplitMethod::cost ? 1 : 0];
    if (split->topologies.empty()) {
        const double start = milliseconds(Clock::process);
        split->topologies = scenes::build_topologies(scene_, options.topology());
        split->ms = milliseconds(Clock::process) - start;
    }
    BuiltSetting built{setting, nullptr, 0};
    const double start = milliseconds(Clock::process);
    built.hierarchies = scenes::shared_hierarchies(split->topologies, setting.volume, options);
    built.ms = split->ms + milliseconds(Clock::process) - start;
    return built;
}

BuiltLayout TuneSubject::pack(const BuiltSetting& built, const PackedLayout& layout) const {
    const auto packed = [&](std::size_t m) {
        return pack_any(layout, (*built.hierarchies)[m], scene_.meshes[m].mesh,
                        scene_.meshes[m].name, build_.threads);
    };
    const double start = milliseconds(Clock::process);
    BuiltLayout result{packed(mesh_a_), packed(mesh_b_), 0};
    result.ms = built.ms + milliseconds(Clock::process) - start;
    return result;
}

double TuneSubject::per_triangle(std::size_t bytes) const {
    std::size_t triangles = 0;
    for (const std::size_t m : {mesh_a_, mesh_b_})
        triangles += scene_.meshes[m].mesh.triangles.size();
    return ratio(static_cast<double>(bytes), static_cast<double>(triangles));
}

double TuneSubject::bytes_per_triangle(const BuiltSetting& built) const {
    return per_triangle(bytes_of((*built.hierarchies)[mesh_a_]) +
                        bytes_of((*built.hierarchies)[mesh_b_]));
}

double TuneSubject::bytes_per_triangle(const BuiltLayout& built) const {
    return per_triangle(bytes_of(built.a) + bytes_of(built.b));
}

Collision TuneSubject::query(const BuiltSetting& built, const TuneSetting& setting,
                             std::size_t frame) const {
    CollideOptions options;
    options.overlap = setting.overlap;
    options.descent = setting.descent;
    const AnyHierarchy& a = (*built.hierarchies)[mesh_a_];
    if (!joined_.empty()) return collide_self(a, scene_.meshes[mesh_a_].mesh, joined_, options);
    return collide(a, scene_.meshes[mesh_a_].mesh, (*built.hierarchies)[mesh_b_],
                   scene_.meshes[mesh_b_].mesh, poses_[frame], options);
}

PackedCollision TuneSubject::query(const BuiltLayout& built, std::size_t frame) {
    return collide_packed(built.a, scene_.meshes[mesh_a_].mesh, built.b,
                          scene_.meshes[mesh_b_].mesh, poses_[frame], {}, &workspace_);
}

QueryAnswer TuneSubject::query(const BuiltSetting& built, const DistanceQuery& asked,
                               std::size_t frame) const {
    return near_answer((*built.hierarchies)[mesh_a_], scene_.meshes[mesh_a_].mesh,
                       (*built.hierarchies)[mesh_b_], scene_.meshes[mesh_b_].mesh, poses_[frame],
                       asked);
}

QueryAnswer TuneSubject::query(const BuiltLayout& built, const DistanceQuery& asked,
                               std::size_t frame) const {
    return near_answer(built.a, scene_.meshes[mesh_a_].mesh, built.b, scene_.meshes[mesh_b_].mesh,
                       poses_[frame], asked);
}

void TuneSubject::prepare(const BuiltSetting& built, std::size_t frame) const {
    CollideOptions slow;
    slow.overlap.test = OverlapTest::extents;
    if (!joined_.empty()) {
        collide_self((*built.hierarchies)[mesh_a_], scene_.meshes[mesh_a_].mesh, joined_, slow);
        return;
    }
    collide((*built.hierarchies)[mesh_b_], scene_.meshes[mesh_b_].mesh,
            (*built.hierarchies)[mesh_a_], scene_.meshes[mesh_a_].mesh,
            relative_pose(poses_[frame], Pose{}), slow);
}

void TuneSubject::prepare(const BuiltLayout& built, std::size_t frame) {
    collide_packed(built.b, scene_.meshes[mesh_b_].mesh, built.a, scene_.meshes[mesh_a_].mesh,
                   relative_pose(poses_[frame], Pose{}), {}, &workspace_);
}

void TuneSubject::prepare(const BuiltSetting& built, const DistanceQuery& asked,
                          std::size_t frame) const {
    near_answer((*built.hierarchies)[mesh_b_], scene_.meshes[mesh_b_].mesh,
                (*built.hierarchies)[mesh_a_], scene_.meshes[mesh_a_].mesh,
                relative_pose(poses_[frame], Pose{}), asked);
}

void TuneSubject::prepare(const BuiltLayout& built, const DistanceQuery& asked,
                          std::size_t frame) const {
    near_answer(built.b, scene_.meshes[mesh_b_].mesh, built.a, scene_.meshes[mesh_a_].mesh,
                relative_pose(poses_[frame], Pose{}), asked);
}

}  // namespace scb::app
