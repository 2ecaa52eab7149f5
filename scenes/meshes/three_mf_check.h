#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that each `transform` of a 3MF model has its twelve numbers: of fewer, assimp's reader
/// takes foreign memory for the rest. Throws InputError that names the file and the element.
void check_3mf_model(std::string_view model, const std::string& name);

/// The same of all models of a package. Says nothing about a file that is no package, which is for
/// assimp to refuse.
void check_3mf(const std::string& path);

}  // namespace scb::scenes
