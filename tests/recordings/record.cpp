// scb_record_engines ENGINE SCENE... [--pose NUMBERS] [--frames LIST] [--models DIR] -o
// FILE.scbrec: has an engine of somebody else's make the queries of a scene, and records them.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>

#include "core/base/exit_status.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/scene/load_scene.h"
#include "scenes/scene/pose_rows.h"
#include "tests/peers/core_mesh.h"
#include "tests/recordings/recorded_engine.h"

namespace scb {
namespace {

struct EngineKind {
    const char* title;
    MakeEngine* make;
    /// Its trees are in the world, and change before each query, which it begins itself.
    bool in_world = false;
};

std::map<std::string, EngineKind> engines() {
    std::map<std::string, EngineKind> all;
#ifdef SCB_RECORD_FCL
    all["fcl"] = {"FCL " SCB_RECORD_FCL, record_fcl};
    all["fcl-distance"] = {"FCL " SCB_RECORD_FCL, record_fcl_distance};
#endif
#ifdef SCB_RECORD_BULLET
    all["bullet"] = {"Bullet " SCB_RECORD_BULLET, record_bullet};
    all["dbvt"] = {"Bullet " SCB_RECORD_BULLET " btDbvt", record_dbvt, true};
#endif
#ifdef SCB_RECORD_EMBREE
    all["embree"] = {"Embree " SCB_RECORD_EMBREE, record_embree};
#endif
#ifdef SCB_RECORD_CGAL
    all["cgal"] = {"CGAL " SCB_RECORD_CGAL, record_cgal};
#endif
    return all;
}

int record(const EngineKind& kind, const scenes::Scene& scene, const std::vector<int>& frames,
           const std::string& output) {
    const scenes::Body &body_a = scene.bodies[0], &body_b = scene.bodies[1];
    scb_recorder recorder{};
    scb_record_open(&recorder, output.c_str(), kind.title);
    scb_record_setting(&recorder, "scene", scene.name.c_str());
    scb_record_setting(&recorder, "results", "pairs");
    const PeerMesh a = peer_mesh(scene.meshes[body_a.mesh].mesh),
                   b = peer_mesh(scene.meshes[body_b.mesh].mesh);
    const RecordedQuery query = kind.make(recorder, a, b);
    for (const int frame : frames) {
        scb_record_frame(&recorder, static_cast<std::uint32_t>(frame));
        const Pose poses[] = {scenes::pose_at(body_a.motion, frame),
                              scenes::pose_at(body_b.motion, frame)};
        for (const std::uint32_t body : {0u, 1u})
            if (!kind.in_world)
                scb_record_pose(&recorder, body, scenes::rows_of(poses[body]).data());
        if (!kind.in_world) scb_record_query(&recorder, 0, 1);
        query(peer_pose(poses[0]), peer_pose(poses[1]));
        scb_record_query_end(&recorder, 1, 0);
    }
    if (const int error = scb_record_close(&recorder); error != 0) {
        std::fprintf(stderr, "%s: %s\n", output.c_str(), std::strerror(error));
        return exit_environment;
    }
    return exit_done;
}

}  // namespace
}  // namespace scb

int main(int argc, char** argv) {
    CLI::App program("Records what another engine does in the queries of a scene");
    std::string name, frames = "all", models, output;
    std::vector<std::string> scene;
    std::vector<double> pose;
    const auto engines = scb::engines();
    program.add_option("ENGINE", name)->required()->check(CLI::IsMember(engines));
    program.add_option("SCENE", scene)->required();
    program.add_option("--frames", frames);
    program.add_option("--pose", pose)->delimiter(',')->expected(12);
    program.add_option("--models", models)->envname("SCB_MODELS");
    program.add_option("-o", output)->required();
    CLI11_PARSE(program, argc, argv);
    try {
        scb::scenes::LoadOptions options;
        if (!models.empty()) options.models_dir = models;
        if (!pose.empty()) {
            scb::scenes::PoseRows rows{};
            std::copy(pose.begin(), pose.end(), rows.begin());
            options.pose = scb::scenes::pose_of(rows);
        }
        const scb::scenes::Scene loaded = scb::scenes::load_scene(scene, options);
        return scb::record(engines.at(name), loaded,
                           scb::parse_frames(frames, loaded.frames, loaded.name), output);
    } catch (const scb::InputError& error) {
        std::fprintf(stderr, "scb_record_engines: %s\n", error.what());
        return scb::exit_bad_input;
    }
}
