#include "scenes/meshes/ply_mesh.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) { fuzz::read_mesh(input, scenes::ply_mesh); }
