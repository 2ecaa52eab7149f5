#pragma once

#include <string>
#include <vector>

#include "scenes/recordings/recording_judgement.h"

namespace scb::app {

/// The verdict on a recording, and the parts that could not be judged: one sentence each, for the
/// beginning of reports and pages.
std::vector<std::string> verdict_lines(const scenes::RecordingJudgement& judged);

/// "tree 0 is 199 deep, where 8 would do".
std::string cost_finding_words(const scenes::CostFinding& cost);

}  // namespace scb::app
