#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/inspect/inspect_report.h"
#include "app/report/table.h"

namespace scb::app {

inline constexpr const char* triangles_heading =
    "triangles in the most tests; N_v: tests of nodes that hold the triangle\n";

/// The triangles of both bodies that take part in the most tests, at most `most` of each: number,
/// tests, share, size.
Table triangles_table(const InspectReport& report, std::size_t most = most_costly);

/// "12 triangles of robot take part in 83 % of the triangle tests."; empty if there are no tests.
std::vector<std::string> triangle_sentences(const InspectReport& report);

/// The savings by each change of the meshes that was tried, and the commands that write the changed
/// meshes: cut triangles; no copies and degenerate triangles. Empty if no change saves enough.
std::vector<std::string> mesh_sentences(const InspectReport& report);
std::vector<std::string> mesh_commands(const InspectReport& report);

nlohmann::ordered_json cuts_json(const InspectReport& report);
nlohmann::ordered_json clean_json(const InspectReport& report);

}  // namespace scb::app
