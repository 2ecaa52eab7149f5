#pragma once

#include "app/inspect/inspect_report.h"
#include "app/pictures/picture_run.h"
#include "app/query/scene_query.h"

namespace scb::app {

/// The name of the picture of all frames, without .png; `more`: further options.
std::string inspect_name(const InspectReport& report, const NamedOptions& more = {});

/// Draws the picture of all frames, and every pair of the report. Calls `step` after each picture;
/// returns false, and ends early, if `step` returns false.
bool draw_inspection(PictureRun& pictures, const PictureOptions& options, const SceneQuery& query,
                     const InspectReport& report, const std::function<bool()>& step);

}  // namespace scb::app
