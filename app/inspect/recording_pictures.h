#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/pictures/picture_run.h"
#include "scenes/recordings/recording.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// A picture of a problem in a recording.
struct ProblemPicture {
    std::string what;  ///< the report's text of the problem
    std::string file;
};

/// Draws the first problem of each kind: faults of trees, wrong tests, missed pairs and false
/// pairs. Throws InputError, OutputError.
std::vector<ProblemPicture> draw_problems(PictureRun& pictures, const PictureOptions& options,
                                          const scenes::Recording& recording,
                                          const scenes::RecordingJudgement& judged);

/// Draws where tests were wasted, in the frame with the most waste. Empty if the recording has no
/// tests, or objects instead of triangles, or queries of several pairs of bodies and `bodies` names
/// none of the pairs.
std::vector<ProblemPicture> draw_waste(PictureRun& pictures, const PictureOptions& options,
                                       std::shared_ptr<const scenes::Recording> recording,
                                       const std::string& bodies,
                                       const scenes::RecordingJudgement& judged);

}  // namespace scb::app
