#pragma once

#include <filesystem>
#include <string>

namespace scb::golden {

/// Which bodies have another mesh, by the files NAME.meta.json of a baseline and of a run: "The
/// mesh of A and B is another: ... instead of ...". Empty where none has, and where either file is
/// missing or says nothing of meshes, as those of older versions do. Throws InputError.
std::string mesh_sentences(const std::filesystem::path& before, const std::filesystem::path& after);

}  // namespace scb::golden
