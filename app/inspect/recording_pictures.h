#pragma once

#include <vector>

#include "app/inspect/inspect_report.h"
#include "app/pictures/picture_run.h"
#include "scenes/recordings/recording.h"

namespace scb::app {

/// Draws the first problem of each kind: faults of trees, wrong tests, missed pairs and false
/// pairs. Throws InputError, OutputError.
std::vector<ProblemPicture> draw_problems(PictureRun& pictures, const PictureOptions& options,
                                          const scenes::Recording& recording,
                                          const scenes::RecordingJudgement& judged);

}  // namespace scb::app
