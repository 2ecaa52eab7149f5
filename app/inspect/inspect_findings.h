#pragma once

#include <string>
#include <vector>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// The main findings, a sentence each: how much was wasted and why, where, and which other test
/// would have helped most.
std::vector<std::string> inspect_findings(const InspectReport& report);

/// "the test rejected 4 pairs of volumes that meet, and so missed 12 pairs of triangles."
std::string wrong_rejections_sentence(const PassCounts& counts);

/// "12 pairs of triangles missed"
std::string missed_words(const WrongRejection& rejection);

}  // namespace scb::app
