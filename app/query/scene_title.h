#pragma once

#include <string>

#include "core/analysis/trace.h"

namespace scb::app {

/// What a title calls a scene, as printable UTF-8, so that no name is there twice: "cheese with
/// itself" for "cheese-cheese", the scene of one mesh twice, whose bodies are "cheese-A" and
/// "cheese-B"; else the scene's name.
std::string scene_title(const std::string& scene, const std::string& a, const std::string& b);
/// The title of a query: of a self query it ends with "against itself".
std::string scene_title(const TraceHeader& header);
/// "left and right", or "left against itself".
std::string bodies_text(const TraceHeader& header);

}  // namespace scb::app
