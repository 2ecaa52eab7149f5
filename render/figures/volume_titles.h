#pragma once

#include <string>
#include <string_view>

#include "core/analysis/trace.h"

namespace scb::render {

/// The name of a kind of volume in titles, tables and legends: "SCB", "ball", "ball (Ritter)",
/// "OBB", "SCB2". (For file names and options see volume_kind_name.)
std::string_view volume_title(VolumeKind kind);

/// The name of the volumes of a trace's queries; for another engine, with its name: "FCL 0.7, OBB".
std::string volume_title(const TraceHeader& header);

}  // namespace scb::render
