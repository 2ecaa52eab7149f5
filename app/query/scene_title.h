#pragma once

#include <string>

#include "core/analysis/trace.h"

namespace scb::app {

/// The scene's title, as printable UTF-8, without repeated names: "cheese with itself" for
/// "cheese-cheese", which is one mesh twice, with the bodies "cheese-A" and "cheese-B"; else the
/// scene's name.
std::string scene_title(const std::string& scene, const std::string& a, const std::string& b);
/// The title of a query; for a self query it ends with "against itself".
std::string scene_title(const TraceHeader& header);
/// "left and right", or "left against itself".
std::string bodies_text(const TraceHeader& header);

}  // namespace scb::app
