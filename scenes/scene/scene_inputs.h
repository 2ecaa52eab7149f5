#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scb::scenes {

/// Notes the files that load_scene would read for these names, see note_input: scene files and the
/// files that they name, mesh files and traces. For a program that lets other processes load them.
/// Ignores files that cannot be read: the process that loads them reports the error.
void note_scene_inputs(const std::vector<std::string>& names,
                       const std::filesystem::path& models_dir);

}  // namespace scb::scenes
