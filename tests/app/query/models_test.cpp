#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/hierarchy/fit_volumes.h"
#include "core/hierarchy/mesh_topology.h"
#include "scb/any_hierarchy.h"
#include "scenes/meshes/mesh_file.h"
#include "tests/app/program.h"
#include "tests/real_models.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> models() {
#ifdef SCB_SANITIZED
    // Sanitizers see no more in large ones, and take ten times as long.
    constexpr std::uintmax_t most_bytes = 200'000;
    std::fprintf(stderr, "NOT TESTED: meshes of more than 200 kB with sanitizers.\n");
#else
    constexpr std::uintmax_t most_bytes = UINTMAX_MAX;
#endif
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(models_folder()))
        if (entry.path().extension() == ".ply" && entry.file_size() <= most_bytes)
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

TEST(Models, EveryOneBuildsAndIsValid) {
    if (!has_model_file("horse.ply", "building real meshes")) GTEST_SKIP();
    for (const fs::path& path : models()) {
        const Mesh mesh = scenes::load_mesh(path);
        const auto topology = std::make_shared<const Topology>(build_topology(mesh));
        const LeafOrder points = leaf_order(mesh, *topology);
        for (const VolumeKind kind : all_volume_kinds())
            EXPECT_EQ(validate(fit_any(kind, topology, points), mesh), "")
                << path << " " << volume_kind_name(kind);
    }
}

TEST(Models, EveryOneRenders) {
    if (!has_model_file("horse.ply", "rendering real meshes")) GTEST_SKIP();
    for (const fs::path& path : models()) {
        const TemporaryFolder folder;
        const ProgramRun run =
            run_scb("render levels " + path.string() +
                    " --levels 4,leaves --size 320x240 --samples 1 -o " + folder.path.string());
        EXPECT_EQ(run.status, 0) << path << run.err;
        const auto index = nlohmann::json::parse(file_text(folder / "index.json"));
        EXPECT_EQ(index["files"][1]["bodies"][0]["volumes"],
                  scenes::load_mesh(path).triangles.size())
            << path;
    }
}

// A CPU of 2008 without AVX and FMA, emulated, must draw the same bytes.
TEST(Emulated, AnOldCpuDrawsTheSameBytes) {
#ifdef SCB_SANITIZED
    std::fprintf(stderr,
                 "NOT TESTED: an emulated CPU, which a sanitizer's shadow memory does not fit.\n");
    return;
#endif
    if (std::system("command -v qemu-x86_64 >/dev/null") != 0) {
        std::fprintf(
            stderr,
            "NOT TESTED: an emulated CPU, since qemu-x86_64 (package qemu-user) is missing.\n");
        return;
    }
    for (const char* scene :
         {"spheres-l1 --levels 6", "thin-cylinder --levels 4 --volume obb",
          "knots-l1 --levels 5 --opacity 0.5", "cone --levels leaves --color-by radius"}) {
        const TemporaryFolder folder;
        const std::string arguments =
            std::string("render levels ") + scene + " --size 320x240 --ids -o ";
        ASSERT_EQ(run_scb(arguments + (folder / "native")).status, 0);
        ASSERT_EQ(
            run_scb_process(arguments + (folder / "emulated"), "qemu-x86_64 -cpu Nehalem").status,
            0);
        std::size_t files = 0;
        for (const auto& entry : fs::directory_iterator(folder / "native")) {
            EXPECT_EQ(file_text(entry.path()),
                      file_text(folder / ("emulated/" + entry.path().filename().string())))
                << entry.path();
            ++files;
        }
        EXPECT_EQ(files, 3u);
    }
}

}  // namespace
}  // namespace scb::app
