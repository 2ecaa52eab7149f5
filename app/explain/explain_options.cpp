#include "app/explain/explain_options.h"

#include <charconv>

#include "core/platform/number_list.h"
#include "scb/error.h"

namespace scb::app {

std::array<std::int64_t, 2> ExplainOptions::nodes() const {
    const std::vector<std::string> parts = split_list(pair);
    std::array<std::int64_t, 2> nodes{};
    bool good = parts.size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const char* end = parts[i].data() + parts[i].size();
        const auto parsed = std::from_chars(parts[i].data(), end, nodes[i]);
        good = parsed.ec == std::errc() && parsed.ptr == end;
    }
    if (!good)
        throw InputError("--pair " + pair +
                         ": give the numbers of two nodes, I,J: one of the first body's hierarchy "
                         "and one of the second's.");
    return nodes;
}

void ExplainOptions::check() const {
    const bool of_scene = !scene.names.empty();
    if (of_scene == !pairs_file.empty())
        throw InputError(of_scene
                             ? "--pairs: the file has the volumes, so there is no scene to name; "
                               "leave out one of them."
                             : "there is nothing to explain; give SCENE --frames N --pair I,J, or "
                               "--pairs FILE.json.");
    if (of_scene && pair.empty())
        throw InputError(
            "which nodes? Give --pair I,J: one of the first body's hierarchy and one "
            "of the second's (`scb trace --events` prints those that were tested).");
    if (of_scene) nodes();
    if (!of_scene && !of_scenes.empty())
        throw InputError(of_scenes[0] +
                         ": it is of scenes, and --pairs has raw volumes; leave it out.");
    query.overlap();
    picture.check();
    camera.check();
    if (!draws() && !of_pictures.empty())
        throw InputError(of_pictures[0] + ": it is of pictures; say where with -o DIR.");
}

void add_explain_options(const Command& command, ExplainOptions& options) {
    add_scene_options(command, options.scene, true);
    command.get_option("SCENE").required(false).expected(0, 2).description(
        "A built-in scene (see `scb scenes`), a scene file, two mesh files, a "
        "trace (see `scb trace`), or another engine's recording");
    command
        .add_option(
            "--pair", options.pair,
            "Node I of the first body's hierarchy and J of the second's; of a recording, by its "
            "engine's numbers")
        .type_name("I,J");
    command
        .add_option("--pairs", options.pairs_file,
                    "In place of a scene: pairs of volumes of your own engine, see below")
        .file({".json"})
        .only_typed();
    add_hierarchy_options(command, options.hierarchy, false);
    add_overlap_options(command, options.query, false);
    add_bodies_option(command, options.query);
    add_picture_options(command, options.picture, options.camera);
    command.remove_option("--ids");
    // The section of --clip would cut both volumes.
    command.remove_option("--clip");
    command.get_option("--output")
        .default_str("")
        .description(
            "Also draw a picture of every pair into this folder; or FILE.png: of the only pair");
    command.get_option("--json").description("Print a list with an object per pair");
    command.get_option("--camera")
        .description(
            "fit, orbit:AZIMUTH,ELEVATION[,DISTANCE[,X,Y,Z]] in degrees, or a JSON "
            "file; default: a camera that shows the step");
}

void note_given(const Command& command, ExplainOptions& options) {
    for (const char* option : {"--pair", "--frames", "--pose", "--poses", "--bodies", "--volume",
                               "--growth", "--margin", "--split"})
        if (command.count(option) > 0) options.of_scenes.emplace_back(option);
    for (const char* option : {"--pose", "--poses", "--volume", "--growth", "--margin", "--split",
                               "--test", "--threshold", "--bodies"})
        if (command.count(option) > 0) options.recording.emplace_back(option);
    for (const char* option :
         {"--size", "--camera", "--up", "--ortho", "--samples", "--background", "--gl"})
        if (command.count(option) > 0) options.of_pictures.emplace_back(option);
}

}  // namespace scb::app
