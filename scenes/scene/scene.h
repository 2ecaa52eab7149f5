#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scb/mesh.h"
#include "scenes/scene/camera_view.h"
#include "scenes/scene/motion.h"

namespace scb::scenes {

/// No scene has more frames.
inline constexpr int most_frames = 1'000'000;

/// A mesh that bodies of a scene share, in its body frame.
struct NamedMesh {
    std::string name;
    Mesh mesh;
    std::filesystem::path file{};  ///< its file; empty if it was made by formula
};

/// A mesh that moves.
struct Body {
    std::string name;
    std::size_t mesh = 0;  ///< index of Scene::meshes
    Motion motion;
};

/// Bodies and their motion, frame by frame: the input of a command. Frames run from 0 to `frames
/// - 1`.
struct Scene {
    std::string name;  ///< fit for a file name: letters, digits, '.', '_' and '-'
    std::string description;
    std::vector<NamedMesh> meshes;
    std::vector<Body> bodies;
    int frames = 1;
    std::vector<int> listed{};  ///< the recorded frames among these, ascending; empty: all
    std::optional<CameraView> camera;
    int default_frame = 0;         ///< the frame to show by default
    std::filesystem::path file{};  ///< its source: a scene file or its only mesh; else empty
};

/// The text with every run of characters that Scene::name does not allow replaced by one '-', cut
/// to 100 characters; "scene" if nothing is left. Different texts keep different names: if letters
/// that are not ASCII or characters behind the cut are lost, a hash of the text is appended.
std::string file_name_of(const std::string& text);

}  // namespace scb::scenes
