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
    /// The files of the scene, its meshes and its logs of poses, with paths from the working
    /// folder; empty for a built-in scene.
    std::vector<std::filesystem::path> files;
};

/// For two bodies or more: the counts of queries of all pairs of bodies, at some frames. For the
/// first two bodies: pictures of their pairs, and of the tests that rejected others, each with the
/// camera that sees the contact, see seeing_camera_words. For any scene: the two levels in which
/// `scb golden selftest` puts errors. The suite will be in `folder`, and its file names are
/// relative to it. Throws InputError if the scene cannot be loaded, or is a trace or a recording;
/// GlError.
FirstSuite first_suite(const SceneOptions& options, const std::filesystem::path& folder);

}  // namespace scb::app
