#pragma once

#include <string>
#include <vector>

#include "render/overlay/side_panel.h"

namespace scb::render {

/// The names of one or two bodies in the columns of a panel: their own names if these are short,
/// else A and B, and then a note is added with the full names: "A spider, B
/// ultimaker_robot_support". `has_letters`: the panel uses A and B elsewhere, so the names are
/// always A and B.
std::vector<std::string> column_names(std::vector<PanelItem>& items,
                                      const std::vector<std::string>& names,
                                      bool has_letters = false);

}  // namespace scb::render
