#pragma once

#include "app/inspect/inspect_report.h"
#include "app/pictures/picture_run.h"
#include "app/query/scene_query.h"

namespace scb::app {

/// The name of the picture of the whole, without .png; `more` names further options.
std::string inspect_name(const InspectReport& report, const NamedOptions& more = {});

/// Draws the whole, and every pair of the report. Ends early, with false, where `step`, which is
/// called after each picture, returns false.
bool draw_inspection(PictureRun& pictures, const PictureOptions& options, const SceneQuery& query,
                     const InspectReport& report, const std::function<bool()>& step);

}  // namespace scb::app
