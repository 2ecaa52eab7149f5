#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// A mesh could not be read for a reason that is not the file's: the process that reads meshes
/// could not do its work, or memory ran out.
struct MeshReaderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads a file by assimp_mesh in another process, so that a file on which a reader of assimp
/// crashes, or takes more memory or time than its size explains, takes that process with it and not
/// this one. What that process may do is in confinement.h. Any thread may call it.
///
/// Throws what assimp_mesh throws; InputError where the process crashed, was killed for its memory
/// or took too long; and MeshReaderError where it cannot be started or confined, has less memory
/// than it needs by a limit from outside, or a signal asked it to end: the file is never read in
/// this process instead.
/// What of the file is not in the mesh is noted, see note_left_out.
Mesh isolated_mesh(const std::string& path);

/// Sets the program that isolated_mesh executes, which is scb. Call this before meshes are read.
void set_mesh_reader(const std::filesystem::path& program);
/// The program that isolated_mesh executes: the program that was set, else the file `scb` beside
/// the running program. Throws MeshReaderError where /proc does not name the running program.
std::filesystem::path mesh_reader();

}  // namespace scb::scenes
