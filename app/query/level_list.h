#pragma once

#include <string>
#include <vector>

#include "scb/level_cover.h"

namespace scb {

/// The levels that a list names: "5,7,9,11", "0:12", "0:12:3", "leaves", "auto" (all), or a
/// mixture; each once, in the order given. Throws InputError where the text is no such list, or
/// names a level below 0 or above `deepest`; `option_name` is what the sentence starts with.
std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::string& option_name = "--levels");

}  // namespace scb
