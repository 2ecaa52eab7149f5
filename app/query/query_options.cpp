#include "app/query/query_options.h"

#include <array>
#include <span>

#include "app/cli/choice.h"
#include "app/cli/command.h"
#include "app/cli/validators.h"
#include "core/base/text_format.h"
#include "core/platform/number_list.h"
#include "scb/error.h"
#include "scenes/scene/builtin.h"

namespace scb::app {
namespace {

std::vector<std::string> test_words() {
    return words_of(choices_of(all_overlap_tests(), overlap_test_name));
}

}  // namespace

std::vector<std::string> scene_endings() {
    return {".json", ".ply", ".obj", ".stl", ".off", ".gltf",   ".glb",
            ".dae",  ".3ds", ".fbx", ".ac",  ".x",   ".scbrec", ".jsonl"};
}

std::vector<std::string> builtin_names() {
    std::vector<std::string> names;
    for (const scenes::BuiltinScene& scene : scenes::builtin_scenes()) names.push_back(scene.name);
    return names;
}

void add_scene_options(const Command& command, SceneOptions& options, bool with_frame) {
    command
        .add_option(
            "SCENE", options.names,
            "A built-in scene (see `scb scenes`), a scene file, a mesh file, two mesh files, or "
            "another engine's recording")
        .required()
        .expected(1, 2)
        .file(scene_endings())
        .offer(builtin_names())
        .type_name("[SCENE]")
        .shareable();
    command
        .add_option("--pose", options.pose,
                    "Pose of the second of two meshes: 12 numbers, [R|t] row by row, with commas")
        .delimiter(',')
        .expected(12)
        .type_name("R00,R01,R02,T0,...")
        .shareable();
    command
        .add_option("--poses", options.poses,
                    "File with the poses of the second of two meshes, one row per frame: 12 "
                    "numbers, or [TIME] tx ty tz qx qy qz qw; A=FILE,B=FILE: of both; "
                    "the names of the bodies are taken, too")
        .file({".csv", ".txt"})
        .type_name("FILE")
        .shareable();
    command
        .add_flag(
            "--exact-pose", options.exact_pose,
            "Refuse a pose whose R^T R differs from the identity by more than 1e-9. Default: up "
            "to 1e-3, the nearest rotation is taken")
        .shareable();
    command
        .add_option("--models", options.models_dir,
                    "Folder to search for meshes that are missing at their given path")
        .envname("SCB_MODELS")
        .folder()
        .shareable();
    command
        .add_option("--query", options.selection.name,
                    "If the input is a recording: use only queries of this name")
        .type_name("NAME")
        .shareable();
    command
        .add_option("--tag", options.selection.tag,
                    "If the input is a recording: use only queries with this tag")
        .type_name("TAG")
        .shareable();
    if (with_frame)
        command
            .add_option("--frames,--frame", options.frames,
                        "Number of one frame. Default: the default frame of the scene")
            .type_name("N")
            .shareable();
}

void add_hierarchy_options(const Command& command, HierarchyOptions& options, bool several,
                           std::string* splits) {
    const Option volume = command
                              .add_option("--volume", options.volumes,
                                          several ? "Bounding volumes: some of " + volume_names(",")
                                                  : "Bounding volume: one of " + volume_names(", "))
                              .type_name(several ? "LIST" : "VOLUME")
                              .show_default();
    volume.any_case().shareable();
    const std::vector<std::string> kinds = split_list(volume_names(","));
    if (several)
        volume.offer_list(kinds);
    else
        volume.offer(kinds);
    constexpr std::array growths = {BallGrowth::radius, BallGrowth::ritter};
    constexpr std::array methods = {SplitMethod::section_3, SplitMethod::cost};
    const std::vector<Choice<SplitMethod>> splits_offered =
        choices_of(std::span<const SplitMethod>(methods), split_method_name);
    add_choice(command, "--growth", options.growth,
               choices_of(std::span<const BallGrowth>(growths), ball_growth_name),
               "A minimum ball of 26 extremal points grows to contain all points: its center moves "
               "(ritter) or stays (radius)")
        .type_name("RULE")
        .shareable();
    const std::string divided =
        "Split of triangles in the build: as in Section 3 of the paper (paper), or by cost (cost: "
        "slower build, quicker queries)";
    if (splits != nullptr)
        command.add_option("--split", *splits, divided)
            .type_name("LIST")
            .offer_list(words_of(splits_offered))
            .show_default()
            .shareable();
    else
        add_choice(command, "--split", options.split, splits_offered, divided)
            .type_name("METHOD")
            .shareable();
    add_choice(command, "--mutation", options.mutation, choices_of(mutation_names),
               "An error on purpose, for `scb golden selftest`")
        .hide();
    command.add_option("--margin", options.margin, "Widen slabs by this share of the radius")
        .check(real_number)
        .show_default()
        .shareable();
}

void add_overlap_options(const Command& command, QueryOptions& options, bool several_tests) {
    const Option test =
        command
            .add_option("--test", options.test,
                        std::string(several_tests
                                        ? "Overlap tests for slab cut balls with one slab: some of "
                                        : "Overlap test for slab cut balls with one slab: ") +
                            name_list(all_overlap_tests(), overlap_test_name) +
                            " (printed misses collisions)")
            .type_name(several_tests ? "LIST" : "TEST")
            .show_default();
    if (several_tests)
        test.offer_list(test_words());
    else
        test.offer(test_words());
    test.shareable().only_typed(std::string(overlap_test_name(OverlapTest::printed)),
                                "it misses collisions");
    command
        .add_option("--threshold", options.threshold,
                    "Threshold a of the paper, for corrected, line8 and printed: a slab is tested "
                    "against a cylinder if |n0.n1| > a")
        .check(real_number)
        .type_name("A")
        .show_default()
        .shareable();
}

std::vector<std::string> compared_words() {
    std::vector<std::string> words = test_words();
    for (const VolumeKind kind : all_volume_kinds()) words.emplace_back(volume_kind_name(kind));
    return words;
}

void add_bodies_option(const Command& command, QueryOptions& options) {
    command
        .add_option("--bodies", options.bodies,
                    "Names of two bodies, if the scene has more than two")
        .type_name("A,B")
        .shareable();
}

void add_traversal_options(const Command& command, QueryOptions& options) {
    const std::vector<Choice<DescentRule>> rules =
        choices_of(all_descent_rules(), descent_rule_name);
    add_choice(command, "--descent", options.descent, rules,
               "Of two overlapping nodes, a query divides the one with the larger radius, area or "
               "volume, or A's and B's in turn: " +
                   offered(rules))
        .type_name("RULE")
        .shareable();
    command
        .add_option("--frames,--frame", options.frames, "Frames: 0,250 or FIRST:LAST[:STEP] or all")
        .type_name("LIST")
        .offer({"all"})
        .show_default()
        .shareable();
    add_bodies_option(command, options);
}

void add_query_options(const Command& command, QueryOptions& options, bool several_tests) {
    add_overlap_options(command, options, several_tests);
    add_traversal_options(command, options);
}

void add_query_limits(const Command& command, QueryLimits& limits) {
    command.add_option("--max-pairs", limits.max_pairs, "End a query at this many pairs")
        .check(decimal_number)
        .type_name("K")
        .show_default()
        .shareable();
    command
        .add_option(
            "--levels,--level", limits.levels,
            "Stop at this level: one number, or 'leaves'; finds pairs of nodes, tests no triangles")
        .type_name("K")
        .offer({"leaves"})
        .shareable();
}

std::vector<std::string> given_hierarchy_options(const Command& command) {
    std::vector<std::string> given;
    for (const char* option : {"--pose", "--poses", "--volume", "--growth", "--margin", "--split"})
        if (command.count(option) > 0) given.emplace_back(option);
    return given;
}

const std::vector<std::string>& recording_options() {
    static const std::vector<std::string> options = {
        "--pose", "--poses",     "--volume",  "--growth", "--margin",    "--split",
        "--test", "--threshold", "--descent", "--bodies", "--max-pairs", "--levels"};
    return options;
}

std::vector<std::string> given_recording_options(const Command& command) {
    std::vector<std::string> given;
    for (const std::string& option : recording_options())
        if (command.count(option) > 0) given.push_back(option);
    return given;
}

void refuse_for_trace(const std::vector<std::string>& given, const std::string& trace) {
    if (given.empty()) return;
    throw InputError(
        given[0] + ": " + trace +
        " is recorded, and has what it was recorded with; give a scene, or leave out " + given[0] +
        ".");
}

}  // namespace scb::app
