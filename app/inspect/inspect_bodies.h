#pragma once

#include <string>

#include "app/inspect/inspect_report.h"
#include "app/pictures/picture_run.h"
#include "app/study/query_sources.h"

namespace scb::app {

/// Draws both bodies in the frame with the most wasted tests. Triangles are colored by the wasted
/// tests that they took part in; squares mark the worst pairs. Returns the picture's file name;
/// empty if nothing was wasted.
std::string draw_bodies(PictureRun& pictures, const PictureOptions& options,
                        const QuerySources& sources, const InspectReport& report);

}  // namespace scb::app
