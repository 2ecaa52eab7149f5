#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "golden/image_difference.h"

namespace scb {

/// What a case makes: the commands of scb.
enum class GoldenRun { levels, pairs, rejections, traversal, inspect, collide };

/// "levels", "pairs", ...
std::string_view golden_run_name(GoldenRun run);

/// Whether it makes a picture; whether that has ids.
bool has_picture(GoldenRun run);
bool has_ids(GoldenRun run);

/// One thing that must not change.
struct GoldenCase {
    std::string name;  ///< as Scene::name; baselines are named after it
    GoldenRun run = GoldenRun::levels;
    std::vector<std::string> scene;      ///< a built-in scene, a scene file, or two mesh files
    std::string frames;                  ///< --frame of levels, --frames of the others; empty: none
    std::string volume, test;            ///< --volume, --test; empty: none
    std::string size;                    ///< of pictures, WIDTHxHEIGHT
    std::vector<std::string> arguments;  ///< more of the command line
    bool counts = true, ids = true, colors = true;  ///< what is compared
    ColorTolerance tolerance;
};

/// The cases of a file, in its order.
struct Suite {
    std::filesystem::path file;
    std::vector<GoldenCase> cases;
};

/// Reads a suite, see golden/README.md. Files that it names are beside it. Throws InputError,
/// naming file and place, for whatever is unknown, missing or out of range, for a name or a preset
/// that is there twice, and for arguments that a case must not have (where it writes, what it
/// prints).
Suite load_suite(const std::filesystem::path& file);

/// The command line of a case after `scb`: writes into `folder`, or prints JSON where it makes no
/// picture.
std::vector<std::string> command_of(const GoldenCase& golden, const std::filesystem::path& folder);

/// The command line that records the trace of the case's query; empty where it makes none, or of
/// more frames than one, whose traces are too large to be kept.
std::vector<std::string> trace_command_of(const GoldenCase& golden,
                                          const std::filesystem::path& file);

}  // namespace scb
