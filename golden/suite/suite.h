#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/enum_names.h"

namespace scb::golden {

/// How much colors of a case may differ; by default not at all.
struct ColorTolerance {
    int max_channel_delta = 0;
    std::size_t max_pixels = 0;  ///< pixels that differ by more than this

    friend bool operator==(const ColorTolerance&, const ColorTolerance&) = default;
};

/// The outputs of a case, by the command of scb; `external`: the counts of another engine's
/// recording, by `scb trace`.
enum class GoldenRun { levels, pairs, rejections, traversal, inspect, collide, distance, external };

inline constexpr EnumNames<GoldenRun, 8> golden_run_names = {
    "levels", "pairs", "rejections", "traversal", "inspect", "collide", "distance", "external"};

/// Whether it makes a picture, and whether that has ids.
bool has_picture(GoldenRun run);
bool has_ids(GoldenRun run);

/// One output that must not change.
struct GoldenCase {
    std::string name;  ///< letters, digits, '_' and '-'; baselines are named after it
    GoldenRun run = GoldenRun::levels;
    std::vector<std::string> scene;  ///< a built-in scene, a scene file, two mesh files, or a
                                     ///< recording
    /// The words of a command that makes the recording of the scene, see recording_here; empty:
    /// none. It runs in the suite's folder.
    std::vector<std::string> command;
    std::string frames;                  ///< --frames; empty: none
    std::string volume, test;            ///< --volume, --test; empty: none
    std::string size = "320x240";        ///< of pictures, WIDTHxHEIGHT
    bool panel = true;                   ///< for pictures of a scene; false: the view alone
    std::vector<std::string> arguments;  ///< further arguments of the command line
    /// The scene and arguments as in the suite: files are relative to its folder, while the paths
    /// above are valid from here.
    std::vector<std::string> own_scene, own_arguments;
    bool counts = true, ids = true, colors = true;  ///< what is compared
    ColorTolerance tolerance;
};

/// Stands in GoldenCase::command for the output file.
inline constexpr const char* recording_here = "{}";

/// The cases of a file, in its order.
struct Suite {
    std::filesystem::path file;
    std::vector<GoldenCase> cases;
};

/// Reads a suite, see golden/README.md. Throws InputError, naming file and place: something is
/// unknown, missing or out of range; a name or a preset occurs twice; there is no case; a case has
/// arguments of its outputs, which it must not; a picture is of several frames or volumes; a
/// comparison or a tolerance is of outputs that the run does not make.
Suite load_suite(const std::filesystem::path& file);

}  // namespace scb::golden
