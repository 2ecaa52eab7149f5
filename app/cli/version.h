#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/context.h"

namespace scb::app {

/// Everything that contributes to a picture: scb, Mesa, LLVM, Eigen, ImGui; name and version, in
/// this order. Without an OpenGL context, only the first and the last ones.
std::vector<std::pair<std::string, std::string>> versions(const render::GlInfo* gl);

/// The same as an object.
nlohmann::ordered_json versions_json(const render::GlInfo* gl);

/// The compiler that built the program, and its flags: "GNU 12.2.0, -O3 -DNDEBUG
/// -ffp-contract=off".
std::string compiler_text();

/// The versions as text, one per line, or as a JSON object; makes an OpenGL context to query it.
std::string version_text();
std::string version_json();

}  // namespace scb::app
