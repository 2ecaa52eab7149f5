#pragma once

#include <optional>

#include "app/inspect/inspected_queries.h"
#include "app/pictures/picture_run.h"

namespace scb::app {

/// Makes the folder of the pictures, and sets the file names of the report. Throws as PictureRun.
void begin_pictures(std::optional<PictureRun>& pictures, InspectedQueries& inspected,
                    const InspectOptions& options);

/// Draws the report and writes all other files. Returns whether everything was drawn: false if
/// interrupted.
bool write_report(PictureRun& pictures, InspectedQueries& inspected, const InspectOptions& options,
                  const ExplainedPairs& explained, const Console& console,
                  const InterruptWatch& watch);

}  // namespace scb::app
