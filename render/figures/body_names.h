#pragma once

#include <string>
#include <vector>

#include "render/overlay/side_panel.h"

namespace scb::render {

/// What the columns of a panel call two bodies, or one: by their names where these are short, else
/// A and B, which a note that is added says in full: "A spider, B ultimaker_robot_support".
std::vector<std::string> column_names(std::vector<PanelItem>& items,
                                      const std::vector<std::string>& names);

}  // namespace scb::render
