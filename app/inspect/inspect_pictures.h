#pragma once

#include <functional>
#include <map>
#include <tuple>

#include "app/inspect/inspect_report.h"
#include "app/pictures/picture_run.h"
#include "app/study/explained_pair.h"

namespace scb::app {

/// "_inspect", with the kind of queries of distances: a part of file names.
std::string name_of_inspection(const InspectReport& report);

/// The name of the picture of all frames, without .png; `more`: further options.
std::string inspect_name(const InspectReport& report, const NamedOptions& more = {});

/// Explanations of pairs of nodes, by frame and by the nodes' numbers.
using ExplainedPairs = std::map<std::tuple<int, std::uint32_t, std::uint32_t>, ExplainedPair>;

/// Explains every pair of the report, and sets the margins of the false pairs.
ExplainedPairs explain_pairs(InspectReport& report, const QuerySource& source);

/// Draws the picture of all frames, and every pair of the report. Calls `step` after each picture;
/// returns false, and ends early, if `step` returns false.
bool draw_inspection(PictureRun& pictures, const PictureOptions& options, const QuerySource& source,
                     const InspectReport& report, const ExplainedPairs& explained,
                     const std::function<bool()>& step);

}  // namespace scb::app
