#pragma once

#include <string_view>

namespace scb {
enum class VolumeKind;
}

namespace scb::render {

/// How a kind of volume is called in titles, tables and legends: "SCB", "ball", "ball (Ritter)",
/// "OBB", "SCB2". (For file names and options see volume_kind_name.)
std::string_view volume_title(VolumeKind kind);

}  // namespace scb::render
