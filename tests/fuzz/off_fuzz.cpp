#include "scenes/meshes/off_mesh.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) { fuzz::read_mesh(input, scenes::off_mesh); }
