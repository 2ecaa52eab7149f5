#include "scenes/meshes/ply_mesh.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

SCB_FUZZ(input) {
    const fuzz::InputFile file(input);
    try {
        const Mesh mesh = scenes::ply_mesh(file.path());
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t v : t)
                fuzz::require(v < mesh.vertices.size(), "triangles name vertices");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, file.path());
    }
}
