#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/program.h"

namespace scb::app {
namespace {

namespace fs = std::filesystem;

using Counts = std::map<std::string, int>;

/// Files that broke something, where they are.
const fs::path hostile = fs::path(SCB_SOURCE_DIR) / "../shared/hostile";

/// Those with triangles in them; all others are refused.
const Counts triangles_of_hostile = {{"a2_vert_indices_ok.ply", 1},
                                     {"a3_vertex_indexes.ply", 1},
                                     {"c3_tristrips.ply", 2},
                                     {"g_face_first.ply", 1},
                                     {"i2_tex_many.ply", 1},
                                     {"i3_tex_first.ply", 1},
                                     {"i_tex_odd.ply", 1},
                                     {"j_tex_tristrip.ply", 1},
                                     {"k_matidx.ply", 1},
                                     {"l_listvertex.ply", 1},
                                     {"m_float_index.ply", 1},
                                     {"n_double_index.ply", 1},
                                     {"o_material.ply", 1},
                                     {"p_textureFile.ply", 1},
                                     {"r_CR.ply", 1},
                                     {"s_CRonly.ply", 1},
                                     {"t_bigface.ply", 59998},
                                     {"tex2.ply", 1},
                                     {"tristrips_restart.ply", 3},
                                     {"w_vertex_late.ply", 1},
                                     {"x_tex_4.ply", 3},
                                     {"mtlfifo.obj", 1},
                                     {"mtlself.obj", 1},
                                     {"mtltty.obj", 1},
                                     {"mtlurandom.obj", 1}};

/// What fuzzers begin with, which this project has made.
const fs::path corpus = fs::path(SCB_SOURCE_DIR) / "tests/fuzz/corpus";
const Counts triangles_of_corpus = {{"binary_big_endian.ply", 3},
                                    {"binary_little_endian.ply", 3},
                                    {"carriage_returns.ply", 2},
                                    {"faces_first.ply", 2},
                                    {"strips.ply", 3},
                                    {"text.ply", 3},
                                    {"a.3ds", 1},
                                    {"a.3mf", 4},
                                    {"a.ac", 1},
                                    {"a.dae", 4},
                                    {"a.glb", 1},
                                    {"a.gltf", 1},
                                    {"text.obj", 6},
                                    {"lines.obj", 4},
                                    {"forwards.obj", 1},
                                    {"a.off", 4},
                                    {"a.x", 1},
                                    {"binary.stl", 2},
                                    {"text.stl", 2}};

void expect_refused(const ProgramRun& run, const std::string& name) {
    EXPECT_EQ(run.status, 2) << name << run.err;
    EXPECT_EQ(run.out, "") << name;
    EXPECT_EQ(lines_of(run.err), 1u) << name << run.err;
    EXPECT_NE(run.err.find(name + ": "), std::string::npos) << name << run.err;
}

/// A file is read, with this many triangles, or refused in one sentence.
void expect_mesh(const fs::path& file, const Counts& triangles) {
    const std::string name = file.filename().string();
    const ProgramRun run = run_scb("stats --json " + file.string());
    const auto expected = triangles.find(name);
    if (expected == triangles.end()) return expect_refused(run, name);
    ASSERT_EQ(run.status, 0) << name << run.err;
    const auto document = nlohmann::json::parse(run.out);
    EXPECT_EQ(document["hierarchies"][0]["triangles"], expected->second) << name;
    EXPECT_EQ(run.err, "") << name;
}

[[maybe_unused]] long most_kilobytes_of_children() {
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_maxrss;
}

TEST(HostileFiles, AreReadOrRefusedInOneSentence) {
    if (!fs::is_directory(hostile)) GTEST_SKIP() << "../shared/hostile is not there";
    const TemporaryFolder folder;
    fs::copy(hostile / "mesh", folder.path / "mesh");
    fs::copy(hostile / "ply", folder.path / "ply");
    fs::copy(hostile / "scene", folder.path / "scene");
    ASSERT_EQ(::mkfifo((folder / "mesh/fifo.ply").c_str(), 0600), 0);
    std::size_t files = 0;
    for (const char* kind : {"mesh", "ply", "scene"})
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / kind)) {
            if (!entry.is_regular_file()) continue;
            ++files;
            const std::string name = entry.path().filename().string();
#ifdef SCB_SANITIZED
            // They take memory until a limit ends it, and a sanitizer's shadow has none.
            if (name == "wide.gltf" || name == "bigsparse.gltf" || name.starts_with("many"))
                continue;
#endif
            expect_mesh(entry.path(), triangles_of_hostile);
        }
    EXPECT_GT(files, 50u);
#ifndef SCB_SANITIZED
    EXPECT_LT(most_kilobytes_of_children(), 2'000'000);
#endif
}

/// What is expected of a file of ../shared/hostile/readers: triangles and the opposite corners of
/// their box, or words of the refusal.
struct Expected {
    int triangles = 0;
    std::array<double, 6> box{};
    std::string refusal{};
};
const std::map<std::string, Expected> expected_of_readers = {
    {"dae_float_array_count_short.dae", {0, {}, "array \"a\" has 3 numbers"}},
    {"dae_empty_init_from.dae", {1, {0, 0, 0, 1, 1, 0}}},
    {"3mf_with_thumbnail.3mf", {4, {0, 0, 0, 1, 1, 1}}},
    {"off_face_over_lines.off", {4, {0, 0, 0, 1, 1, 1}}},
    {"off_binary.off", {0, {}, "binary OFF is not read"}},
    {"gltf_no_scenes.gltf", {1, {0, 0, 0, 1, 1, 0}}},
    {"gltf_gpu_instancing_used.gltf", {3, {0, 0, 0, 2, 2, 0}}},
    {"obj_vertex_weight.obj", {1, {0, 0, 0, 1, 1, 0}}},
    {"gltf_draco_quantized.gltf", {4, {0, 0, 0, 16384, 16384, 16384}}}};

TEST(HostileFiles, ThatReadersMisreadAreReadRight) {
    if (!fs::is_directory(hostile / "readers"))
        GTEST_SKIP() << "../shared/hostile/readers is not there";
    for (const auto& [name, expected] : expected_of_readers) {
        const ProgramRun run =
            run_scb_process("--no-config stats --json " + (hostile / "readers" / name).string());
        if (!expected.refusal.empty()) {
            expect_refused(run, name);
            EXPECT_NE(run.err.find(expected.refusal), std::string::npos) << run.err;
            continue;
        }
        ASSERT_EQ(run.status, 0) << name << run.err;
        const auto hierarchy = nlohmann::json::parse(run.out)["hierarchies"][0];
        EXPECT_EQ(hierarchy["triangles"], expected.triangles) << name;
        const auto& box = hierarchy["facts"]["box"];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(box["lower"][axis], expected.box[axis]) << name;
            EXPECT_EQ(box["upper"][axis], expected.box[axis + 3]) << name;
        }
        EXPECT_EQ(run.err, "") << name;
    }
    // A new file gets a row.
    for (const fs::directory_entry& entry : fs::directory_iterator(hostile / "readers"))
        EXPECT_TRUE(entry.path().extension() == ".md" ||
                    expected_of_readers.contains(entry.path().filename().string()))
            << entry.path();
}

class HostileRecording : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::is_directory(recordings))
            GTEST_SKIP() << "../shared/hostile/recording is not there";
    }
    const fs::path recordings = hostile / "recording";
    const TemporaryFolder folder;
};

// Of one scene and one engine: the second kept the name of the first, and replaced its pictures.
TEST_F(HostileRecording, DoesNotReplaceThePicturesOfAnotherOne) {
    std::set<std::string> pictures;
    for (const char* name : {"before", "after"}) {
        const fs::path file = recordings / (std::string(name) + ".scbrec");
        const ProgramRun run = run_scb("inspect " + file.string() + " -o " + (folder / "out"));
        ASSERT_EQ(run.status, 0) << run.err;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / "out"))
            if (entry.path().extension() == ".png") pictures.insert(entry.path().filename());
        EXPECT_EQ(run.err.find("replaced"), std::string::npos) << run.err;
    }
    const auto of = [&](const std::string& name) {
        return std::count_if(pictures.begin(), pictures.end(),
                             [&](const std::string& file) { return file.starts_with(name); });
    };
    for (const char* name : {"before", "after"}) EXPECT_GT(of(name), 0) << name;
}

TEST_F(HostileRecording, LosesNothingOnItsWayThroughJson) {
    const std::string text = folder / "a.jsonl", again = folder / "a.scbrec",
                      text_again = folder / "b.jsonl";
    ASSERT_EQ(run_scb("convert " + (recordings / "lossy.scbrec").string() + " -o " + text).status,
              0);
    ASSERT_EQ(run_scb("convert " + text + " -o " + again).status, 0);
    ASSERT_EQ(run_scb("convert " + again + " -o " + text_again).status, 0);
    EXPECT_EQ(file_text(text), file_text(text_again));
    // A signalling NaN, the bytes of a later version, and "complete" that is neither 0 nor 1.
    for (const char* kept : {"nan:7ff4000020000000", "appended", "\"complete\":2"})
        EXPECT_NE(file_text(text).find(kept), std::string::npos) << file_text(text);
}

TEST_F(HostileRecording, NamesTheCauseOf40000MissedPairs) {
    const ProgramRun run = run_scb("inspect " + (recordings / "miss200.scbrec").string());
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_EQ(run.out.find("Wrong: 40,000 pairs missed.\n"), 0u) << run.out;
    EXPECT_NE(run.out.find("\nCost: tree 0 \"t\" is 199 deep, where 8 would do"), std::string::npos)
        << run.out;
}

TEST_F(HostileRecording, HasNumbersThatNoLocaleChanges) {
    const ProgramRun run =
        run_scb_process("--no-config stats --json " + (recordings / "locale.ply").string());
    ASSERT_EQ(run.status, 0) << run.err;
    const auto box = nlohmann::json::parse(run.out)["hierarchies"][0]["facts"]["box"];
    EXPECT_EQ(box["lower"], nlohmann::json({0, 0, 0}));
    EXPECT_EQ(box["upper"], nlohmann::json({1, 1, 0}));
}

// The command is a stranger's: of a very long word only the start is printed.
TEST_F(HostileRecording, OfAShardIsNotPrintedWhole) {
    const ProgramRun run =
        run_scb("merge " + (recordings / "merge_16.json").string() + " -o " + (folder / "out"));
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("shard 2/2 is missing"), std::string::npos) << run.err;
    EXPECT_LT(run.err.size(), 500u);
    EXPECT_FALSE(fs::exists(folder.path / "out"));
}

// As the real program reads them; their fuzzers read them again under sanitizers.
TEST(HostileFiles, OfTheCorpusAreReadOrRefusedInOneSentence) {
    const TemporaryFolder folder;
    for (const char* kind : {"ply", "obj", "mesh"})
        for (const fs::directory_entry& entry : fs::directory_iterator(corpus / kind))
            expect_mesh(entry.path(), triangles_of_corpus);
    const std::map<std::string, std::string> commands = {
        {"scene", "collide FILE --frames 0 --csv"},
        {"trace", "trace FILE"},
        {"pairs", "explain --pairs FILE --json"},
        {"suite", "golden list --suite FILE"},
        {"camera",
         "render levels cone --levels 1 --size 320x240 --camera FILE -o " + (folder / "out")}};
    for (const auto& [kind, command] : commands)
        for (const fs::directory_entry& entry : fs::directory_iterator(corpus / kind)) {
            std::string words = command;
            words.replace(words.find("FILE"), 4, entry.path().string());
            const ProgramRun run = run_scb(words);
            if (run.status == 0) continue;
            expect_refused(run, entry.path().filename().string());
        }
}

// What is left of the address space may be too little for anything.
TEST(HostileLimits, OfMemoryEndInASentence) {
#ifdef SCB_SANITIZED
    GTEST_SKIP() << "a sanitizer's shadow takes more";
#endif
    const TemporaryFolder folder;
    std::string pairs = "[";
    for (int i = 0; i < 20'000; ++i)
        pairs +=
            std::string(i == 0 ? "" : ",") +
            R"({"a": {"center": [0, 0, 0], "radius": 1}, "b": {"center": [1, 0, 0], "radius": 1}})";
    const std::string file = folder.write("pairs.json", pairs + "]");
    bool drawn = false, explained = false;
    for (int megabytes = 250; megabytes <= 4000; megabytes += megabytes < 800 ? 50 : 1600) {
        const std::string limit = "ulimit -v " + std::to_string(1000 * megabytes) + ";";
        for (const std::string& command :
             {"render levels cone --levels 3 --size 320x240 -o " + (folder / "out"),
              "explain --json --pairs " + file}) {
            const ProgramRun run = run_scb_process(command, limit);
            if (run.status == 0) {
                (command[0] == 'r' ? drawn : explained) = true;
                continue;
            }
            EXPECT_EQ(run.status, 3) << limit << command << run.err;
            EXPECT_EQ(lines_of(run.err), 1u) << limit << command << run.err;
            EXPECT_EQ(run.err.find("please report"), std::string::npos) << limit << run.err;
        }
    }
    EXPECT_TRUE(drawn);
    EXPECT_TRUE(explained);
}

}  // namespace
}  // namespace scb::app
