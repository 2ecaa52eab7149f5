#pragma once

#include <string>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// A row per frame, in their order: counts of passed pairs by reason, and of all and wasted work.
std::string frames_csv(const InspectReport& report);

/// A row per pair of the report: the worst false pairs of each reason, then the wrong rejections.
std::string pairs_csv(const InspectReport& report);

}  // namespace scb::app
