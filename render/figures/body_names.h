#pragma once

#include <string>
#include <vector>

#include "render/overlay/side_panel.h"

namespace scb::render {

/// What the columns of a panel call two bodies, or one: by their names where these are short, else
/// A and B, which a note that is added says in full: "A spider, B ultimaker_robot_support".
/// `has_letters`: the panel speaks of A and B elsewhere, so that these are the names in any case.
std::vector<std::string> column_names(std::vector<PanelItem>& items,
                                      const std::vector<std::string>& names,
                                      bool has_letters = false);

}  // namespace scb::render
