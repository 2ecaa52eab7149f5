#include <cstdlib>
#include <fstream>

#include "scenes/meshes/collada_plain.h"
#include "scenes/meshes/gltf_plain.h"
#include "scenes/meshes/isolated_mesh.h"
#include "scenes/meshes/three_mf_check.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/stored_zip.h"
#include "tests/temporary_folder.h"

using namespace scb;

namespace {

/// In memory that nothing was written to, the process that reads has these bytes.
Mesh read(const std::string& file, int filling) {
    const std::string number = std::to_string(filling);
    ::setenv("MALLOC_PERTURB_", number.c_str(), 1);
    ::setenv("ASAN_OPTIONS",
             ("detect_leaks=0:max_malloc_fill_size=1000000000:malloc_fill_byte=" + number).c_str(),
             1);
    return scenes::isolated_mesh(file);
}

}  // namespace

// COLLADA, glTF and 3MF; for 3MF, an input is the model alone. Each input is read twice, each time
// by a process of the program, which has the sanitizers too. A reader of assimp may crash there. If
// it returns a mesh, the mesh must be the same both times.
SCB_FUZZ(input) {
    static const TemporaryFolder folder;
    std::string bytes(reinterpret_cast<const char*>(input.data()), input.size());
    scenes::set_mesh_reader(SCB_PROGRAM);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == bytes.npos) return;
    const bool is_gltf = bytes.starts_with("glTF") || bytes[first] == '{';
    std::string file = folder / (is_gltf ? "input.gltf" : "input.dae");
    try {
        // What this process looks through guides the fuzzer.
        if (is_gltf) {
            scenes::plain_gltf(bytes, file);
        } else if (bytes.find("<model") != bytes.npos) {
            scenes::check_3mf_model(bytes, file);
            file = folder / "input.3mf";
            bytes = package_3mf(bytes);
        } else {
            scenes::plain_collada(bytes, file);
        }
        std::ofstream(file, std::ios::binary) << bytes;
        const Mesh mesh = read(file, 0x55);
        fuzz::require(fuzz::same_bits(mesh, read(file, 0xaa)),
                      "a mesh is the same when it is read again");
    } catch (const InputError& error) {
        fuzz::require_sentence(error, file);
    }
}
