#pragma once

#include <string>

#include "app/query/output_guard.h"
#include "app/query/scene_options.h"

namespace scb::app {

/// Throws InputError where `path` is one of the files that name the scene.
void refuse_overwriting(const std::string& path, const std::string& option,
                        const SceneOptions& scene);

/// Throws InputError where `path` is standard output or one of the files that name the scene, and
/// OutputError where there cannot be such a file. `folder_to_make` is one that will be there by
/// then.
void check_output(const std::string& path, const std::string& option, const SceneOptions& scene,
                  const std::string& folder_to_make = "");

/// Throws InputError where a mesh of the scene was read from `path`: a scene file may name any.
void check_output(const std::string& path, const std::string& option, const scenes::Scene& scene);

/// Throws InputError where `path` is a file that the scene was read from, whatever names it.
void refuse_inputs(const std::string& path, const std::string& option, const SceneOptions& options,
                   const scenes::Scene& scene);

}  // namespace scb::app
