#include "scenes/meshes/collada_check.h"
#include "scenes/meshes/gltf_check.h"
#include "scenes/meshes/off_check.h"
#include "scenes/meshes/tds_check.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

// What looks through files before assimp gets them: each of these through any bytes.
SCB_FUZZ(input) {
    const std::string_view bytes(reinterpret_cast<const char*>(input.data()), input.size());
    for (const auto check :
         {scenes::check_gltf, scenes::check_off, scenes::check_3ds, scenes::check_collada})
        try {
            check(bytes, "the file");
        } catch (const InputError& error) {
            fuzz::require_sentence(error, "the file");
        }
}
