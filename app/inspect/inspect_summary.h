#pragma once

#include <string>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// The findings on waste that matter first: advice, costly triangles, and of a scene the worst
/// frames and pairs. With the title at most 40 lines of 100 characters, unless names or commands
/// are long.
std::string inspect_summary(const InspectReport& report);

}  // namespace scb::app
