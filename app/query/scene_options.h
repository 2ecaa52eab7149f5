#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "scb/any_hierarchy.h"
#include "scenes/scene/load_scene.h"

namespace scb {

/// What every command that takes a SCENE understands.
struct SceneOptions {
    std::vector<std::string> names;
    std::vector<double> pose;
    std::string models_dir;
    std::optional<int> frame;

    Scene load() const;
    /// The frame asked for, or the scene's own; throws InputError, with the range, where there is
    /// no such frame.
    int frame_of(const Scene& scene) const;
};

/// The names as UTF-8, for JSON and headers.
std::vector<std::string> utf8_names(const std::vector<std::string>& names);

/// Throws InputError where `path` is one of the files that name the scene.
void refuse_overwriting(const std::string& path, const std::string& option,
                        const SceneOptions& scene);

/// Throws InputError where `path` is standard output or one of the files that name the scene, and
/// OutputError where there cannot be such a file. `folder_to_make` is one that will be there by
/// then.
void check_output(const std::string& path, const std::string& option, const SceneOptions& scene,
                  const std::string& folder_to_make = "");

/// Throws InputError where a mesh of the scene was read from `path`: a scene file may name any.
void check_output(const std::string& path, const std::string& option, const Scene& scene);

/// Throws InputError where `path` is a file that the scene was read from, whatever names it.
void refuse_inputs(const std::string& path, const std::string& option, const SceneOptions& options,
                   const Scene& scene);

void add_scene_options(CLI::App& command, SceneOptions& options, bool with_frame);

/// How hierarchies are built.
struct HierarchyOptions {
    std::string volumes = "scb";
    std::string growth = "ritter";
    double margin = 0;
    std::string split = "paper";

    BuildOptions build() const;
    /// The volumes asked for, each once; throws InputError for an unknown name.
    std::vector<VolumeKind> kinds() const;
    /// The one volume asked for; throws InputError where there are several.
    VolumeKind kind() const;
};
/// `several`: whether --volume takes a list.
void add_hierarchy_options(CLI::App& command, HierarchyOptions& options, bool several = true);

/// Refuses an empty name.
CLI::Validator has_name();

/// Refuses what is no whole number in decimal: CLI11 alone reads 010 as 8, and holds a number that
/// is too large for the largest one.
CLI::Validator decimal_number();
/// The same for numbers with a fraction.
CLI::Validator real_number();

/// "1,2,3" cut at the separators; empty parts stay.
std::vector<std::string> split_list(const std::string& text, char separator = ',');

/// An integer that is the whole text; throws InputError that starts with `what` and ends with
/// `hint`.
int whole_number(const std::string& text, const std::string& what, const std::string& hint = ".");

}  // namespace scb
