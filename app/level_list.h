#pragma once

#include <string>
#include <vector>

#include "core/level_cover.h"

namespace scb {

/// The levels that a list names: "5,7,9,11", "0:12", "0:12:3", "leaves", or a mixture; each once,
/// in the order given. Throws InputError where the text is no such list, or names a level below 0
/// or above `deepest`.
std::vector<int> parse_levels(const std::string& text, int deepest);

/// "7", or "leaves" for leaf_level.
std::string level_name(int level);

}  // namespace scb
