#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/analysis/assumed_time.h"
#include "core/base/statistics.h"
#include "core/platform/clock.h"
#include "scb/any_collide.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"

// Whether assumed_time ranks volumes as the clock of this machine does: per scene and volume, the
// measured time of the queries over their assumed time, and the rank correlation of both.
namespace scb {
namespace {

constexpr const char* some_scenes[] = {"spheres-l1", "knots-l2",    "horses",  "hands",
                                       "tube",       "tray_bottom", "aatbase", "tr12j"};
constexpr int most_frames = 20, rounds = 5;
constexpr double far_off = 1.3;

/// Per volume, in the order of all_volume_kinds.
struct SceneTimes {
    std::string name;
    std::vector<double> measured, assumed;  ///< nanoseconds
};

SceneTimes times_of(const scenes::Scene& scene) {
    const scenes::Body &a = scene.bodies[0], &b = scene.bodies[1];
    const Mesh &mesh_a = scene.meshes[a.mesh].mesh, &mesh_b = scene.meshes[b.mesh].mesh;
    BuildOptions options;
    options.split = SplitMethod::cost;
    const std::vector<AnyHierarchy> of_a = build_hierarchies(mesh_a, all_volume_kinds(), options),
                                    of_b = build_hierarchies(mesh_b, all_volume_kinds(), options);
    std::vector<Pose> poses;
    const int step = (scene.frames + most_frames - 1) / most_frames;
    for (int frame = 0; frame < scene.frames; frame += step)
        poses.push_back(
            relative_pose(scenes::pose_at(a.motion, frame), scenes::pose_at(b.motion, frame)));
    SceneTimes times{scene.name, {}, std::vector<double>(of_a.size())};
    // Volumes take turns, so that a slower moment of the machine is of all of them.
    std::vector<std::vector<double>> of_rounds(of_a.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < of_a.size(); ++i) {
            std::vector<Collision> found;
            const double began = milliseconds(Clock::thread);
            for (const Pose& pose : poses)
                found.push_back(collide(of_a[i], mesh_a, of_b[i], mesh_b, pose));
            of_rounds[i].push_back(1e6 * (milliseconds(Clock::thread) - began));
            if (round > 0) continue;
            for (const Collision& one : found)
                times.assumed[i] += static_cast<double>(assumed_time(
                                        all_volume_kinds()[i], {}, CollideOptions{}.descent, one)) /
                                    1000;
        }
    for (std::vector<double>& of_round : of_rounds)
        times.measured.push_back(median(std::move(of_round)));
    return times;
}

void print(const std::vector<SceneTimes>& scenes) {
    std::vector<double> ratios, measured, assumed;
    for (const SceneTimes& scene : scenes)
        for (std::size_t i = 0; i < scene.measured.size(); ++i) {
            ratios.push_back(scene.measured[i] / scene.assumed[i]);
            measured.push_back(scene.measured[i]);
            assumed.push_back(scene.assumed[i]);
        }
    const double usual = median(ratios);
    std::printf(
        "Measured over assumed time, over the median of %.2f. *: by %.1f times or more.\n\n", usual,
        far_off);
    std::printf("%-12s", "");
    for (const SceneTimes& scene : scenes) std::printf(" %12s", scene.name.c_str());
    std::size_t far = 0;
    for (std::size_t i = 0; i < all_volume_kinds().size(); ++i) {
        std::printf("\n%-12s", std::string(volume_kind_name(all_volume_kinds()[i])).c_str());
        for (const SceneTimes& scene : scenes) {
            const double off = scene.measured[i] / scene.assumed[i] / usual;
            const bool marked = off >= far_off || off * far_off <= 1;
            far += marked;
            std::printf(" %11.2f%c", off, marked ? '*' : ' ');
        }
    }
    std::printf("\n\n%-12s", "ranks");
    for (const SceneTimes& scene : scenes)
        std::printf(" %11.3f ", rank_correlation(scene.measured, scene.assumed));
    std::printf("\n\nMarked: %zu of %zu. Rank correlation over all: %.3f.\n", far, ratios.size(),
                rank_correlation(measured, assumed));
}

int run(const std::vector<std::string>& names) {
    const char* models = std::getenv("SCB_MODELS");
    std::vector<SceneTimes> scenes;
    for (const std::string& name : names) {
        const scenes::BuiltinScene* scene = scenes::find_builtin(name);
        if (scene == nullptr) throw InputError(name + ": this is no built-in scene.");
        scenes.push_back(times_of(scenes::load_builtin(*scene, models ? models : "")));
    }
    print(scenes);
    return 0;
}

}  // namespace
}  // namespace scb

/// Arguments: names of built-in scenes of two bodies. The variable SCB_MODELS names the folder of
/// their models.
int main(int count, char** words) {
    std::vector<std::string> names(words + 1, words + count);
    if (names.empty()) names.assign(std::begin(scb::some_scenes), std::end(scb::some_scenes));
    try {
        return scb::run(names);
    } catch (const scb::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
