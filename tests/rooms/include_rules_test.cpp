#include "tests/rooms/include_rules.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace scb {
namespace {

namespace fs = std::filesystem;

std::vector<SourceFile> sources() {
    std::vector<SourceFile> files;
    for (const char* folder : {"core", "scenes", "render", "golden", "app"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(fs::path(SCB_SOURCE_DIR) / folder)) {
            const fs::path& path = entry.path();
            if (path.extension() != ".h" && path.extension() != ".cpp") continue;
            std::ifstream in(path);
            files.push_back({fs::relative(path, SCB_SOURCE_DIR).string(),
                             {std::istreambuf_iterator<char>(in), {}}});
        }
    return files;
}

TEST(IncludeRules, HoldInEveryFile) {
    const std::vector<SourceFile> files = sources();
    ASSERT_GT(files.size(), 500u);
    for (const SourceFile& file : files)
        for (const std::string& broken : broken_rules(file)) ADD_FAILURE() << broken;
}

TEST(IncludeRules, KnowEveryPublicHeader) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(SCB_SOURCE_DIR) / "core/include/scb"))
        names.push_back(entry.path().stem().string());
    EXPECT_EQ(homeless_headers(names), std::vector<std::string>{});
    EXPECT_GE(homeless_headers({"nowhere"}).size(), 40u);
}

/// The folders of the top level, except hidden folders and folders that .gitignore names.
std::vector<std::string> top_folders() {
    std::set<std::string> ignored;
    std::ifstream in(fs::path(SCB_SOURCE_DIR) / ".gitignore");
    for (std::string line; std::getline(in, line);) {
        const std::size_t start = line.starts_with('/') ? 1 : 0;
        if (line.ends_with('/')) ignored.insert(line.substr(start, line.size() - start - 1));
    }
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(SCB_SOURCE_DIR)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_directory() && !name.starts_with('.') && !ignored.contains(name))
            names.push_back(name);
    }
    return names;
}

TEST(IncludeRules, KnowEveryFolderOfTheTopLevel) {
    const std::vector<std::string> names = top_folders();
    EXPECT_EQ(names.size(), 6u);
    EXPECT_EQ(unknown_folders(names), std::vector<std::string>{});
    EXPECT_EQ(unknown_folders({"core", "extra", "tests"}), std::vector<std::string>{"extra"});
}

TEST(IncludeRules, KnowEveryRoom) {
    EXPECT_EQ(unknown_rooms(sources()), std::vector<std::string>{});
    EXPECT_EQ(unknown_rooms({{"core/extra/x.cpp", ""},
                             {"core/extra/y.cpp", ""},
                             {"core/base/x.cpp", ""},
                             {"core/include/scb/x.h", ""},
                             {"app/main.cpp", ""}}),
              std::vector<std::string>{"core/extra"});
}

// Each rule, broken once.
TEST(IncludeRules, AreSeenToBreak) {
    const struct {
        const char *path, *included;
    } broken[] = {
        {"core/fit/fit.cpp", "scenes/shapes/icosphere.h"},
        {"scenes/scene/scene.cpp", "render/view/camera.h"},
        {"render/view/camera.cpp", "scenes/scene/scene.h"},
        {"render/draw/renderer.cpp", "golden/suite/suite.h"},
        {"golden/run/run_case.cpp", "app/cli/console.h"},
        {"app/view/view.cpp", "app/python/binding/view.h"},
        {"core/geometry/mesh.cpp", "core/volumes/any_volume.h"},
        {"core/fit/fit.cpp", "core/overlap/overlap_slabs.h"},
        {"core/fit/fit.cpp", "scb/collide.h"},
        {"core/packed/collapse.cpp", "core/analysis/trace.h"},
        {"core/packed/collapse.cpp", "core/model/tree.h"},
        {"core/explain/exact_overlap.h", "scb/collide.h"},
        {"core/include/scb/fit.h", "core/fit/dop26.h"},
        {"core/include/scb_record.h", "scb/vec.h"},
        {"core/include/scb/vec.h", "scb/mesh.h"},
        {"scenes/shapes/icosphere.cpp", "scenes/scene/scene.h"},
        {"render/gl/context.cpp", "render/view/camera.h"},
        {"render/plots/bar_plot.cpp", "render/draw/renderer.h"},
        {"golden/compare/comparison.cpp", "golden/report/junit.h"},
        {"golden/report/junit.cpp", "golden/run/run_case.h"},
        {"core/collide/collide.cpp", "core/packed/collapse.h"},
        {"core/overlap/overlap.cpp", "scb/hierarchy.h"},
        {"scenes/shapes/icosphere.cpp", "scenes/meshes/mesh_file.h"},
        {"core/judge/tree_check.cpp", "core/platform/utf8.h"},
        {"core/platform/utf8.cpp", "core/fit/fit.h"},
        {"core/platform/utf8.cpp", "render/files/image_file.h"},
        {"scenes/meshes/polygon.cpp", "scenes/scene/scene.h"},
        {"scenes/scene/scene.cpp", "scenes/recordings/trace_file.h"},
        {"render/files/image_file.cpp", "render/gl/context.h"},
        {"render/view/camera.cpp", "render/overlay/overlay.h"},
        {"render/overlay/overlay.cpp", "render/plots/bar_plot.h"},
        {"render/plots/bar_plot.cpp", "render/figures/bench_figure.h"},
        {"golden/suite/suite.cpp", "golden/compare/comparison.h"},
        {"golden/run/run_case.cpp", "golden/report/junit.h"},
        {"app/query/collide.cpp", "app/pictures/picture_run.h"},
        {"app/pictures/picture_run.cpp", "app/timing/bench.h"},
        {"app/cli/console.cpp", "app/study/scene_query.h"},
        {"app/report/table.cpp", "app/cli/console.h"},
        {"app/report/table.cpp", "app/study/scene_query.h"},
        {"app/report/table.cpp", "iostream"},
        {"app/study/tune_run.cpp", "app/cli/command.h"},
        {"app/study/tune_run.cpp", "app/shards/shard_options.h"},
        {"app/study/tune_run.cpp", "app/query/query_options.h"},
        {"app/study/tune_run.cpp", "cstdio"},
        {"app/timing/bench.cpp", "app/explain/explain_json.h"},
        {"app/golden/check.cpp", "app/inspect/inspect_report.h"},
        {"app/inspect/inspect.cpp", "app/python/binding/view.h"},
    };
    for (const auto& [path, included] : broken) {
        const std::vector<std::string> found =
            broken_rules({path, "#pragma once\n#include \"" + std::string(included) + "\"\n"});
        ASSERT_EQ(found.size(), 1u) << path << " " << included;
        EXPECT_TRUE(found[0].starts_with(std::string(path) + ":2: ")) << found[0];
        EXPECT_NE(found[0].find(included), std::string::npos) << found[0];
    }
    EXPECT_EQ(broken_rules({"core/collide/collide.cpp",
                            "#include <vector>\n#include <scb/fit.h>\n#include "
                            "\"core/overlap/overlap_slabs.h\"\n"})
                  .size(),
              0u);
    EXPECT_EQ(broken_rules({"app/python/binding/queries.cpp",
                            "#include \"app/inspect/inspect_report.h\"\n#include "
                            "\"app/python/binding/view.h\"\n"})
                  .size(),
              0u);
}

}  // namespace
}  // namespace scb
