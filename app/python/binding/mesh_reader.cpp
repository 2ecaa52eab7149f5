// Reads a mesh file for the package, in its own process: see scenes/meshes/isolated_mesh.h.

#include <unistd.h>

#include <cstring>

#include "core/base/exit_status.h"
#include "scenes/meshes/mesh_answer.h"
#include "scenes/meshes/mesh_reader.h"

int main(int argc, char** argv) {
    if (argc != 3 || std::strcmp(argv[1], scb::scenes::mesh_reader_command) != 0)
        return scb::exit_bad_input;
    ::_exit(scb::scenes::run_mesh_reader(argv[2]));
}
