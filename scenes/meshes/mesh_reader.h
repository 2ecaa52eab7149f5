#pragma once

#include <string>

namespace scb::scenes {

/// What `scb read-mesh PATH` does: greets, then writes what assimp_mesh makes of the file, or what
/// it throws, to mesh_answer_descriptor, see mesh_answer.h. Returns the exit status. The process
/// reads nothing before it is confined, see confine_this_process.
int run_mesh_reader(const std::string& path);

}  // namespace scb::scenes
