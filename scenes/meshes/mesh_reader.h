#pragma once

#include <string>

namespace scb::scenes {

/// Runs `scb read-mesh PATH`: greets, then writes the result of assimp_mesh, or its exception, to
/// mesh_answer_descriptor, see mesh_answer.h. Returns the exit status. The process reads nothing
/// before it is confined, see confine_this_process.
int run_mesh_reader(const std::string& path);

}  // namespace scb::scenes
