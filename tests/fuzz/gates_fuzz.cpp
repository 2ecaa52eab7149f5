#include "scenes/meshes/collada_plain.h"
#include "scenes/meshes/gltf_plain.h"
#include "scenes/meshes/tds_check.h"
#include "tests/fuzz/fuzz_input.h"

using namespace scb;

// What looks through files before assimp gets them: each of these through any bytes.
SCB_FUZZ(input) {
    const std::string_view bytes(reinterpret_cast<const char*>(input.data()), input.size());
    const std::string name = "the file";
    const auto try_with = [&](const auto& action) {
        try {
            action();
        } catch (const InputError& error) {
            fuzz::require_sentence(error, name);
        }
    };
    for (const auto plain : {scenes::plain_gltf, scenes::plain_collada})
        try_with([&] {
            // Like assimp, each takes what it made itself.
            if (const auto once = plain(bytes, name))
                fuzz::require(plain(once->bytes, name).has_value(), "a plain file is one");
        });
    try_with([&] { scenes::check_3ds(bytes, name); });
}
