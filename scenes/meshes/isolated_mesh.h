#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "scb/mesh.h"

namespace scb::scenes {

/// A mesh could not be read, but not because of the file: the process that reads meshes could not
/// do its work, or memory ran out.
struct MeshReaderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads a file by assimp_mesh in another process, so that a file on which a reader of assimp
/// crashes, or takes more memory or time than its size explains, ends only that process. For its
/// permissions see confinement.h. Any thread may call it.
///
/// Throws what assimp_mesh throws; InputError if the process crashed, was killed for its memory or
/// took too long; and MeshReaderError if it cannot be started or confined, has too little memory
/// because of a limit from outside, or was ended by a signal. The file is never read in this
/// process instead. The parts of the file that are not in the mesh are noted, see note_left_out.
Mesh isolated_mesh(const std::string& path);

/// Sets the program that isolated_mesh executes, which is scb. Call this before meshes are read.
void set_mesh_reader(const std::filesystem::path& program);
/// The program that isolated_mesh executes: the program that was set, else the file `scb` beside
/// the running program. Throws MeshReaderError if /proc does not name the running program.
std::filesystem::path mesh_reader();

}  // namespace scb::scenes
