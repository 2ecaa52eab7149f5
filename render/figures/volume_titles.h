#pragma once

#include <string>
#include <string_view>

#include "core/analysis/trace.h"

namespace scb::render {

/// How a kind of volume is called in titles, tables and legends: "SCB", "ball", "ball (Ritter)",
/// "OBB", "SCB2". (For file names and options see volume_kind_name.)
std::string_view volume_title(VolumeKind kind);

/// Of the volumes of such queries; of another engine with its name: "FCL 0.7, OBB".
std::string volume_title(const TraceHeader& header);

}  // namespace scb::render
