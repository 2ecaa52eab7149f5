#pragma once

#include <filesystem>
#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// Reads a file by assimp_mesh in another process, so that a file on which a reader of assimp
/// crashes, or does not come to an end in five minutes, takes that process with it and not this
/// one. Any thread may call it.
///
/// Throws what assimp_mesh throws; InputError where the process crashed or gave no mesh; and
/// filesystem_error where it cannot be started: nothing is read in this process instead.
Mesh isolated_mesh(const std::string& path);

/// The program that isolated_mesh executes, which is scb; where nobody has set it, the file of that
/// name beside the running program. Not to be set while a mesh is being read.
void set_mesh_reader(const std::filesystem::path& program);

/// What isolated_mesh has the program do: `scb read-mesh PATH`. It is no command for users.
inline constexpr const char* mesh_reader_command = "read-mesh";
/// Writes what assimp_mesh makes of the file, or what it throws, where isolated_mesh reads it.
/// Returns the exit status.
int run_mesh_reader(const std::string& path);

}  // namespace scb::scenes
