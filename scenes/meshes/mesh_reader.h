#pragma once

#include <string>

namespace scb::scenes {

/// What `scb read-mesh PATH` does: greets, then writes what assimp_mesh makes of the file, or what
/// it throws, to mesh_answer_descriptor, see mesh_answer.h. Returns the exit status. The process
/// ends with who started it, after five minutes of reading, and where it crashes without a core
/// file.
int run_mesh_reader(const std::string& path);

}  // namespace scb::scenes
