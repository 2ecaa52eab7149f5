#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/query/scene_options.h"

namespace scb::app {

/// A first suite of a scene, as text, and what a repository must have for it.
struct FirstSuite {
    std::string text;
    std::size_t cases = 0;
    /// The files of the scene and of its meshes, as they are named from here; none of a built-in
    /// scene.
    std::vector<std::filesystem::path> files;
};

/// Of two bodies what a query counts over some frames, the pairs that it finds and how tests
/// rejected the others; of any scene two levels, those in which `scb golden selftest` puts errors.
/// The suite will be in `folder`, and names files from there. Throws InputError where the scene
/// cannot be loaded, or is a trace or a recording.
FirstSuite first_suite(const SceneOptions& options, const std::filesystem::path& folder);

}  // namespace scb::app
