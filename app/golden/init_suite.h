#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/query/query_options.h"

namespace scb::app {

/// A first suite for a scene, as text, and the files that its repository must have.
struct FirstSuite {
    std::string text;
    std::size_t cases = 0;
    /// The files of the scene and of its meshes, with paths from the working folder; empty for a
    /// built-in scene.
    std::vector<std::filesystem::path> files;
};

/// For two bodies: the counts of queries at some frames, their pairs, and how tests rejected other
/// pairs. For any scene: the two levels in which `scb golden selftest` puts errors. The suite will
/// be in `folder`, and its file names are relative to it. Throws InputError if the scene cannot be
/// loaded, or is a trace or a recording.
FirstSuite first_suite(const SceneOptions& options, const std::filesystem::path& folder);

}  // namespace scb::app
