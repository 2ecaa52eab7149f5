#pragma once

#include <string>

#include "app/inspect/inspect_report.h"
#include "app/pictures/picture_run.h"
#include "app/query/query_sources.h"

namespace scb::app {

/// Draws both bodies in their pose at the frame with the most wasted tests: each triangle by the
/// wasted tests that it took part in, with squares about the worst pairs. Returns the picture's
/// file name; empty where nothing was wasted.
std::string draw_bodies(PictureRun& pictures, const PictureOptions& options,
                        const QuerySources& sources, const InspectReport& report);

}  // namespace scb::app
