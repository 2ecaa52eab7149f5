#include "scenes/meshes/mesh_answer.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

// What a process sends that a stranger's file has taken over.
SCB_FUZZ(input) {
    const auto answer = scenes::receive_answer([&](std::span<std::byte> bytes) {
        if (bytes.size() > input.size()) return false;
        if (!bytes.empty()) std::memcpy(bytes.data(), input.data(), bytes.size());
        input = input.subspan(bytes.size());
        return true;
    });
    if (!answer) return;
    fuzz::require(answer->sentence.find('\n') == std::string::npos, "a sentence is one line");
    if (answer->kind != scenes::MeshAnswer::mesh) return;
    try {
        check_mesh(answer->mesh, "input");
        for (const Triangle& t : answer->mesh.triangles)
            for (const std::uint32_t v : t)
                fuzz::require(v < answer->mesh.vertices.size(), "triangles name vertices");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, "input");
    }
}
