#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/pictures/picture_run.h"
#include "scenes/recordings/recording.h"
#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// A picture of something that went wrong in a recording.
struct ProblemPicture {
    std::string what;  ///< what the report calls it
    std::string file;
};

/// Draws the first of each kind of problem: of trees, of tests, missed pairs and false pairs.
/// Throws InputError, OutputError.
std::vector<ProblemPicture> draw_problems(PictureRun& pictures, const PictureOptions& options,
                                          const scenes::Recording& recording,
                                          const scenes::RecordingJudgement& judged);

/// Draws where the tests were wasted in the frame with the most waste. Nothing where the recording
/// has queries of several pairs of bodies of which `bodies` names none, objects, or no tests.
std::vector<ProblemPicture> draw_waste(PictureRun& pictures, const PictureOptions& options,
                                       std::shared_ptr<const scenes::Recording> recording,
                                       const std::string& bodies,
                                       const scenes::RecordingJudgement& judged);

}  // namespace scb::app
