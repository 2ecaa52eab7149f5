#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks that each `transform` of a 3MF model has its twelve numbers: if there are fewer, assimp's
/// reader reads foreign memory for the rest. Throws InputError that names the file and the element.
void check_3mf_model(std::string_view model, const std::string& name);

/// The same for all models of a package. Does not report a file that is not a package, which assimp
/// refuses.
void check_3mf(const std::string& path);

}  // namespace scb::scenes
