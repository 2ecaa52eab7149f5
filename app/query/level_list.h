#pragma once

#include <string>
#include <vector>

#include "scb/level_cover.h"

namespace scb::app {

/// The levels in a list: "5,7,9,11", "0:12", "0:12:3", "leaves", "all", "auto" (the levels in
/// `automatic`), or a mixture; each once, in the order given. Throws InputError if the text is no
/// such list, or names a level below 0 or above `deepest`. `name`: the option's.
std::vector<int> parse_levels(const std::string& text, int deepest,
                              const std::vector<int>& automatic = {},
                              const std::string& name = "--levels");

/// The same for a command that takes one level. Throws InputError if the text names several.
int parse_level(const std::string& text, int deepest, const std::string& name = "--levels");

}  // namespace scb::app
